// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.SEAR.POJOs.ScriptSession;
import org.junit.rules.ExternalResource;

/** Messages of the grammar during a test. */
final class SaidRule extends ExternalResource {
    final List<String> said = Collections.synchronizedList(new ArrayList<>());
    final ScriptSession bench = new ScriptSession(said::add);

    @Override
    protected void before() {
        bench.open();
    }

    @Override
    protected void after() {
        bench.close();
    }
}
