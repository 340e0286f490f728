package org.myrobotlab.service.config;

import java.util.ArrayList;
import java.util.List;

/** Configuration of Python. */
public class PythonConfig extends ServiceConfig {
    /** Where scripts are opened from and saved to; null for the working folder. */
    public String scriptRootDir;
    /** Run when the service starts. */
    public List<String> startScripts = new ArrayList<>();
    /** Run when the service is released. */
    public List<String> stopScripts = new ArrayList<>();
    /** Folders that modules are imported from. */
    public List<String> modulePaths = new ArrayList<>();
}
