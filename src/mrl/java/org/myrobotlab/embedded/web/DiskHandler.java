// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import io.undertow.server.HttpHandler;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.Headers;
import io.undertow.util.MimeMappings;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.Paths;

/** Serves the files of a folder, which may change at any time; passes other requests to the next handler. */
final class DiskHandler implements HttpHandler {
    private final Path root;
    private final HttpHandler next;

    DiskHandler(String folder, HttpHandler next) {
        this.root = Paths.get(folder).toAbsolutePath().normalize();
        this.next = next;
    }

    @Override
    public void handleRequest(HttpServerExchange exchange) throws Exception {
        if (exchange.isInIoThread()) {
            exchange.dispatch(this);
            return;
        }
        Path file = find(exchange.getRelativePath());
        if (file == null) {
            next.handleRequest(exchange);
            return;
        }
        String name = file.getFileName().toString();
        String type = MimeMappings.DEFAULT.getMimeType(name.substring(name.lastIndexOf('.') + 1));
        exchange.getResponseHeaders().put(Headers.CONTENT_TYPE, type == null ? "application/octet-stream" : type);
        exchange.getResponseSender().send(ByteBuffer.wrap(Files.readAllBytes(file)));
    }

    /** Returns the file; null if there is none or it is outside the folder. */
    private Path find(String path) throws IOException {
        try {
            Path file = root.resolve(path.replaceFirst("^/+", "")).normalize();
            return file.startsWith(root) && Files.isRegularFile(file) && file.toRealPath().startsWith(root.toRealPath())
                ? file : null;
        } catch (InvalidPathException e) {
            return null;
        }
    }
}
