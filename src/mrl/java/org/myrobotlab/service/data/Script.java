// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.data;

import java.io.Serializable;

/** A script open in the editor. */
public class Script implements Serializable {
    private static final long serialVersionUID = 1L;

    public String file;
    public String code;

    public Script(String file, String code) {
        this.file = file;
        this.code = code;
    }

    @Override
    public String toString() {
        return file;
    }
}
