// SPDX-License-Identifier: Apache-2.0
package org.SEAR.architecture;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Names of the classes that a class file refers to, from its constant pool (JVMS, section 4.4). */
final class ClassNames {
    private static final int UTF8 = 1;
    private static final int LONG = 5;
    private static final int DOUBLE = 6;
    private static final int CLASS = 7;
    private static final int HEADER = 8;
    private static final Pattern IN_A_DESCRIPTOR = Pattern.compile("L([\\w/$]+)[;<]");

    private ClassNames() {
    }

    /** Returns names with slashes, from class constants, descriptors and signatures. */
    static Set<String> in(byte[] classFile) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(classFile));
        in.skipBytes(HEADER);
        String[] texts = new String[in.readUnsignedShort()];
        int[] classes = new int[texts.length];
        for (int i = 1; i < texts.length; i++) {
            int tag = in.readUnsignedByte();
            if (tag == UTF8) {
                texts[i] = in.readUTF();
            } else if (tag == CLASS) {
                classes[i] = in.readUnsignedShort();
            } else {
                in.skipBytes(size(tag));
            }
            i += tag == LONG || tag == DOUBLE ? 1 : 0;
        }
        return names(texts, classes);
    }

    /** Returns the length of a fixed-size constant after its tag, bytes. */
    private static int size(int tag) {
        switch (tag) {
            case LONG:
            case DOUBLE:
                return 8;
            case 8:
            case 16:
            case 19:
            case 20:
                return 2;
            case 15:
                return 3;
            default:
                return 4;
        }
    }

    private static Set<String> names(String[] texts, int[] classes) {
        Set<String> names = new TreeSet<>();
        for (int i = 1; i < texts.length; i++) {
            if (classes[i] > 0 && !texts[classes[i]].startsWith("[")) {
                names.add(texts[classes[i]]);
            }
            if (texts[i] != null) {
                Matcher matcher = IN_A_DESCRIPTOR.matcher(texts[i]);
                while (matcher.find()) {
                    names.add(matcher.group(1));
                }
            }
        }
        return names;
    }
}
