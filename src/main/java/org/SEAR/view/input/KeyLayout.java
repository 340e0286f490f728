// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.input;

import com.jme3.input.KeyInput;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/**
 * Maps keys to commands on this keyboard. jMonkeyEngine numbers keys by their position on a US keyboard, but users read
 * the labels. A key with the right label wins; without one, the key at the US position is used. Window thread only.
 */
public final class KeyLayout {
    private final Map<Integer, Key> keys = new HashMap<>();

    /** @param input provides the labels; null for a US keyboard */
    public KeyLayout(KeyInput input) {
        Map<String, Integer> printed = printed(input);
        for (Key key : Key.values()) {
            for (int code : key.codes()) {
                keys.putIfAbsent(code, key);
            }
        }
        for (Key key : Key.values()) {
            Integer code = printed.get(key.label.toLowerCase(Locale.ROOT));
            if (code != null) {
                keys.put(code, key);
            }
        }
    }

    private static Map<String, Integer> printed(KeyInput input) {
        Map<String, Integer> labels = new HashMap<>();
        for (int code = KeyInput.KEY_1; input != null && code <= KeyInput.KEY_SLASH; code++) {
            String label = input.getKeyName(code);
            if (label != null) {
                labels.putIfAbsent(label.toLowerCase(Locale.ROOT), code);
            }
        }
        return labels;
    }

    /** Returns the command of a key, or null. */
    Key key(int code) {
        return keys.get(code);
    }

    /** Returns 0 for the key 1, 8 for the key 9. */
    static int digit(int code) {
        return code - KeyInput.KEY_1;
    }
}
