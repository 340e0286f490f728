// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** Meta data of WebGui. */
public class WebGuiMeta extends MetaData {
    private static final long serialVersionUID = 1L;

    public WebGuiMeta() {
        addDescription("shows services in a browser");
        addCategory("display");
    }
}
