// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.config;

import java.util.ArrayList;
import java.util.List;

/** Configuration of WebGui. */
public class WebGuiConfig extends ServiceConfig {
    /** TCP port on this computer. */
    public Integer port = 8888;
    /** Whether a browser opens at the start. */
    public boolean autoStartBrowser;
    public boolean enableMdns;
    /** Folders on disk with panels. */
    public List<String> resources = new ArrayList<>(List.of("resource/WebGui/app", "resource"));
}
