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
    @Option(names = "--host", paramLabel = "ADDRESS", description = "Let other computers reach the tabs: an address of this computer, or 0.0.0.0 for "
        + "all that it has. They need the token. What they send is not encrypted: docs/classroom.md. Default: this computer alone.")
    private String host;
    @Option(names = "--url", paramLabel = "URL", description = "How browsers reach the tabs, if otherwise than by address and port of this computer: "
        + "https://HOST behind a proxy, http://HOST:PORT from a container.")
    private String url;
    @Option(names = "--token", description = "Have the tabs and programs that call services ask for a token, which is printed with the address and "
        + "written into a file that only you can read. Ports that are exported over TCP ask for none.")
    private boolean token;
    @Option(names = "--token-file", paramLabel = "FILE", description = "The same with the token in a file that only you can read, 16 characters or "
        + "more, 32 for one that stays good when the program starts anew. The port is then the one that was asked for, or none.")
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
