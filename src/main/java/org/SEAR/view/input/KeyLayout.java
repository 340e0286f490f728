package org.SEAR.view.input;

import com.jme3.input.KeyInput;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/**
 * Which key does what on this keyboard. jMonkeyEngine numbers keys by where they lie on an American keyboard; users look at what is printed on them.
 * So a key that carries the label wins, wherever it lies; where no key carries it, the key in the American place does it. Window thread only.
 */
public final class KeyLayout {
    private final Map<Integer, Key> keys = new HashMap<>();

    /** @param input knows what is printed on the keys; null for an American keyboard */
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

    /** What the key does; null for nothing. */
    Key key(int code) {
        return keys.get(code);
    }

    /** 0 for the key 1, 8 for the key 9. */
    static int digit(int code) {
        return code - KeyInput.KEY_1;
    }
}
