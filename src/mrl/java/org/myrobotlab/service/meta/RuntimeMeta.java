// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** Meta data of Runtime. */
public class RuntimeMeta extends MetaData {
    private static final long serialVersionUID = 1L;

    public RuntimeMeta() {
        addDescription("makes, starts and releases services");
        addCategory("framework");
    }
}
