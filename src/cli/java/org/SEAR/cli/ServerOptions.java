// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import java.io.IOException;
import java.nio.file.Path;
import org.SEAR.project.problems.FileReasons;
import org.myrobotlab.embedded.web.Address;
import org.myrobotlab.embedded.web.Token;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** Options for access to the tabs: address, URL and token. */
final class ServerOptions {
    @Option(names = "--host", paramLabel = "ADDRESS", description = "Let other computers reach the tabs: an address of "
        + "this computer, or 0.0.0.0 for "
        + "all of them. They need the token, and the connection is not encrypted: docs/classroom.md. Default: this "
            + "computer only.")
    private String host;
    @Option(names = "--url", paramLabel = "URL", description = "Address of the tabs for browsers, if not this "
        + "computer's address and port: https://HOST behind a proxy, http://HOST:PORT from a container.")
    private String url;
    @Option(names = "--token", description = "Require a token from the tabs and from programs that call services. SEAR "
        + "prints it with the address "
        + "and writes it to a file that only you can read. Ports exported over TCP need no token.")
    private boolean token;
    @Option(names = "--token-file", paramLabel = "FILE", description = "Require the token in a file that only you can "
        + "read, of 16 or more "
        + "characters; with 32 or more, browsers stay logged in when SEAR restarts. SEAR then tries no other port.")
    private Path file;

    /** Sets address and token of servers that start from now on. */
    void apply(CommandSpec spec) {
        try {
            boolean isOpen = !Address.listen(host, url).isLoopback();
            if (file != null) {
                Token.require(file);
            } else if (token || isOpen) {
                Token.require();
            }
        } catch (IOException e) {
            throw new ParameterException(spec.commandLine(), "--token-file: " + FileReasons.of(e), e);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage(), e);
        }
    }

    /** Returns whether the link was handed out before the start, so that another port is useless. */
    boolean isKnown() {
        return file != null;
    }
}
