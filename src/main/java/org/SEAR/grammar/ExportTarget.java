// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Target of a port export: {@code ttySICK}, a link of that name in the folder SEARports, or {@code tcp:5001} or
 * {@code rfc2217:5001}, a TCP port of this computer. Projects are untrusted, so a target contains neither a folder nor
 * a port below 1024. Immutable, any thread.
 */
public final class ExportTarget {
    static final String LEGAL = "the name of a link in the folder SEARports (a file name, no path, for example "
        + "ttySICK), or tcp:PORT or rfc2217:PORT with PORT from 1024 to 65535";
    private static final int LOWEST_PORT = 1024;
    private static final int HIGHEST_PORT = 65535;
    private static final Pattern TCP = Pattern.compile("(tcp|rfc2217):([1-9][0-9]{3,4})");
    private static final Pattern ONLY_DIGITS = Pattern.compile("[0-9]+");

    private final String link;
    private final boolean rfc2217;
    private final int number;

    private ExportTarget(String link, boolean rfc2217, int number) {
        this.link = link;
        this.rfc2217 = rfc2217;
        this.number = number;
    }

    static boolean isLegal(String text) {
        Matcher tcp = TCP.matcher(text);
        if (tcp.matches()) {
            int number = Integer.parseInt(tcp.group(2));
            return number >= LOWEST_PORT && number <= HIGHEST_PORT;
        }
        return TextRule.NAME.allows(text) && !ONLY_DIGITS.matcher(text).matches();
    }

    /**
     * Parses a target.
     *
     * @param text as written in the project
     * @throws IllegalArgumentException with the legal forms
     */
    public static ExportTarget of(String text) {
        if (!isLegal(text)) {
            throw new IllegalArgumentException("export is " + ParameterTable.quote(text) + ", legal: " + LEGAL);
        }
        Matcher tcp = TCP.matcher(text);
        return !tcp.matches() ? new ExportTarget(text, false, 0)
            : new ExportTarget(null, tcp.group(1).equals("rfc2217"), Integer.parseInt(tcp.group(2)));
    }

    /** Returns whether the target is a link to a pseudo-terminal. */
    public boolean isLink() {
        return link != null;
    }

    /** Returns the link's file name; null for a TCP port. */
    public String getLink() {
        return link;
    }

    /** Returns whether the TCP port speaks RFC 2217. */
    public boolean isRfc2217() {
        return rfc2217;
    }

    /** Returns the TCP port, 1024 to 65535. */
    public int getNumber() {
        return number;
    }
}
