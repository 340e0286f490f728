// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.UnknownHostException;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * The address at which servers listen: this computer only, unless {@code --host} asks for more; and the names by which
 * browsers reach it. Any thread.
 */
public final class Address {
    private static final String LOOPBACK = "127.0.0.1";
    private static final String PORT = "{port}";
    private static final Set<String> SCHEMES = Set.of("http", "https");
    private static final Pattern NUMERIC = Pattern.compile("[0-9]+(\\.[0-9]+){3}|\\[[0-9a-f:.]+\\]");
    /** Documentation address that belongs to no computer (RFC 5737); nothing is sent there. */
    private static final String ELSEWHERE = "192.0.2.1";
    private static final int WEB = 80;
    private static volatile Address current = new Address(InetAddress.getLoopbackAddress(), LOOPBACK, null);

    private final InetAddress listening;
    private final String host;
    private final String url;

    private Address(InetAddress listening, String host, String url) {
        this.listening = listening;
        this.host = host;
        this.url = url;
    }

    /** Returns the address of servers that start now. */
    public static Address current() {
        return current;
    }

    /**
     * Sets the address of servers that start from now on.
     *
     * @param host a name or number of this computer; 0.0.0.0 for all its IPv4 addresses, :: for all; null for this
     *     computer only
     * @param url address for browsers, if different: http://HOST:PORT or https://HOST; {port} becomes the server's
     *     port; may be null
     * @throws IllegalArgumentException if host or url is invalid
     */
    public static Address listen(String host, String url) {
        if (url != null) {
            authority(url.replace(PORT, "1"));
        }
        try {
            String name = host == null ? LOOPBACK : host;
            current = new Address(InetAddress.getByName(name), name, url);
        } catch (UnknownHostException e) {
            throw new IllegalArgumentException("\"" + host + "\" is not an address of this computer", e);
        }
        return current;
    }

    /** Makes servers that start from now on listen on this computer only. */
    public static void dismiss() {
        current = new Address(InetAddress.getLoopbackAddress(), LOOPBACK, null);
    }

    /** Returns whether only programs of this computer can connect. */
    public boolean isLoopback() {
        return listening.isLoopbackAddress();
    }

    /** Returns the socket address to bind. */
    public InetSocketAddress socket(int port) {
        return new InetSocketAddress(isLoopback() && host.equals(LOOPBACK) ? InetAddress.getLoopbackAddress()
            : listening, port);
    }

    /** Returns the address for browsers, without a slash at the end: {@code http://localhost:8888}. */
    public String url(int port) {
        if (url != null) {
            return url.replace(PORT, String.valueOf(port)).replaceFirst("/$", "");
        }
        String name = host;
        if (isLoopback()) {
            name = "localhost";
        } else if (listening.isAnyLocalAddress()) {
            name = outside();
        }
        return "http://" + (name.contains(":") ? "[" + name + "]" : name) + ":" + port;
    }

    /** Returns this computer's own address on routes to other computers. */
    private static String outside() {
        try (DatagramSocket socket = new DatagramSocket()) {
            socket.connect(InetAddress.getByName(ELSEWHERE), WEB);
            InetAddress local = socket.getLocalAddress();
            return local.isAnyLocalAddress() ? hostName() : local.getHostAddress();
        } catch (IOException | RuntimeException e) {
            return hostName();
        }
    }

    private static String hostName() {
        try {
            return InetAddress.getLocalHost().getHostName();
        } catch (UnknownHostException e) {
            return "localhost";
        }
    }

    /** Returns host and port as browsers write them into the header Host. */
    private static String authority(String url) {
        String legal = "\"" + url + "\" is not an address of this server, legal: http://HOST, http://HOST:PORT, "
            + "https://HOST, https://HOST:PORT";
        try {
            URI uri = new URI(url);
            String scheme = String.valueOf(uri.getScheme()).toLowerCase(Locale.ROOT);
            boolean isBare = uri.getUserInfo() == null && uri.getQuery() == null && uri.getFragment() == null
                && uri.getPath().matches("/?");
            if (uri.getHost() == null || !SCHEMES.contains(scheme) || !isBare) {
                throw new IllegalArgumentException(legal);
            }
            boolean isUsual = uri.getPort() < 0 || uri.getPort() == (scheme.equals("http") ? WEB : 443);
            return uri.getHost().toLowerCase(Locale.ROOT) + (isUsual ? "" : ":" + uri.getPort());
        } catch (URISyntaxException e) {
            throw new IllegalArgumentException(legal, e);
        }
    }

    /** Returns the names of a server on a port. */
    Names names(int port) {
        Set<String> names = new HashSet<>(Set.of("localhost", LOOPBACK, "[::1]"));
        if (!isLoopback()) {
            String own = hostName().toLowerCase(Locale.ROOT);
            names.add(own);
            names.add(own + ".local");
        }
        names.add(host.toLowerCase(Locale.ROOT));
        return new Names(names, port, url == null ? null : url(port));
    }

    /**
     * Accepted host names and origins of a server. They exclude names that another server points at this one (DNS
     * rebinding).
     */
    static final class Names {
        private final Set<String> hosts;
        private final int port;
        private final String outer;
        private final String outerHost;

        private Names(Set<String> hosts, int port, String outer) {
            this.hosts = hosts;
            this.port = port;
            this.outer = outer;
            this.outerHost = outer == null ? null : authority(outer);
        }

        /**
         * Returns whether a Host header names this server.
         *
         * @param reached the address of this computer that received the request
         */
        boolean has(String header, InetAddress reached) {
            String text = header.toLowerCase(Locale.ROOT);
            String end = ":" + port;
            if (text.equals(outerHost)) {
                return true;
            }
            if (!text.endsWith(end) && port != WEB) {
                return false;
            }
            String name = text.endsWith(end) ? text.substring(0, text.length() - end.length()) : text;
            return hosts.contains(name) || isNumberOf(name, reached);
        }

        /** A numeric address is safe from DNS rebinding. */
        private static boolean isNumberOf(String name, InetAddress reached) {
            try {
                return NUMERIC.matcher(name).matches() && InetAddress.getByName(name).equals(reached);
            } catch (UnknownHostException e) {
                return false;
            }
        }

        /** Returns the origin of this server's own pages for a Host header. */
        String origin(String header) {
            return header.toLowerCase(Locale.ROOT).equals(outerHost) && isSecure(header) ? "https://" + header
                : "http://" + header;
        }

        /** Returns whether requests with this Host header come over an encrypted connection. */
        boolean isSecure(String header) {
            return header.toLowerCase(Locale.ROOT).equals(outerHost) && outer.toLowerCase(Locale.ROOT)
                .startsWith("https:");
        }

        /** Returns one of the names, for messages. */
        String one() {
            return outerHost == null ? "localhost" : outerHost;
        }
    }
}
