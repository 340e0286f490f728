package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** What Runtime is for. */
public class RuntimeMeta extends MetaData {
    private static final long serialVersionUID = 1L;

    public RuntimeMeta() {
        addDescription("makes, starts and releases services");
        addCategory("framework");
    }
}
