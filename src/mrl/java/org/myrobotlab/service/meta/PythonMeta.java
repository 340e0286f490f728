// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** Meta data of Python. */
public class PythonMeta extends MetaData {
    private static final long serialVersionUID = 1L;

    public PythonMeta() {
        addDescription("runs Python scripts");
        addCategory("programming");
    }
}
