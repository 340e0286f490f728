// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import static org.junit.Assert.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.Test;
import org.myrobotlab.codec.CodecUtils;

/** Fields become JSON by name, in order. */
public class JsonFormTest {
    private static class Above extends JsonForm {
        final int first = 1;
        Optional<String> always = Optional.empty();
        String maybe;
    }

    private static final class Below extends Above {
        List<Above> inside = List.of();
        double[] last = {1.5};
    }

    @Test
    public void aNullIsLeftOutAndAnEmptyOptionalIsNull() {
        Below form = new Below();
        assertEquals("{\"first\":1,\"always\":null,\"inside\":[],\"last\":[1.5]}", CodecUtils.toJson(form.map()));
        form.always = Optional.of("a");
        form.maybe = "b";
        form.inside = List.of(new Above());
        assertEquals("{\"first\":1,\"always\":\"a\",\"maybe\":\"b\",\"inside\":[{\"first\":1,\"always\":null}],"
            + "\"last\":[1.5]}", CodecUtils.toJson(form.map()));
    }

    @Test
    public void onlyChangesAreSentAndRemovedFieldsAsNull() {
        Below before = new Below();
        before.maybe = "b";
        before.inside = List.of(new Above());
        Below now = new Below();
        now.inside = List.of(new Above());
        now.inside.get(0).maybe = "c";
        assertEquals("{\"maybe\":null,\"inside\":[{\"first\":1,\"always\":null,\"maybe\":\"c\"}]}",
            CodecUtils.toJson(now.since(before)));
        assertEquals("equal arrays are equal", "{}", CodecUtils.toJson(new Below().since(new Below())));
    }
}
