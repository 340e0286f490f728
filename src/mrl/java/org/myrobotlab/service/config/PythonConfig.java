// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.config;

import java.util.ArrayList;
import java.util.List;

/** Configuration of Python. */
public class PythonConfig extends ServiceConfig {
    /** Folder of scripts; null for the working folder. */
    public String scriptRootDir;
    /** Scripts to run when the service starts. */
    public List<String> startScripts = new ArrayList<>();
    /** Scripts to run when the service is released. */
    public List<String> stopScripts = new ArrayList<>();
    /** Folders of the module path. */
    public List<String> modulePaths = new ArrayList<>();
}
