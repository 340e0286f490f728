package org.SEAR.project;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import org.SEAR.POJOs.Notices;
import org.junit.rules.ExternalResource;

/** What the grammar said while a test ran. */
final class SaidRule extends ExternalResource {
    final List<String> said = Collections.synchronizedList(new ArrayList<>());
    private final Consumer<String> listener = said::add;

    @Override
    protected void before() {
        Notices.listen(listener);
    }

    @Override
    protected void after() {
        Notices.leave(listener);
        Notices.setSimulating(() -> false);
    }
}
