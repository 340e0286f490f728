// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Fenced block of README.md, CONTRIBUTING.md or a page of docs, for the tests that run it. */
public final class DocBlock {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final Pattern BLOCK = Pattern.compile("(?:^`([\\w./-]+)`:\n\n)?^( *)```([^\n]*)\n(.*?)^ *```$",
        Pattern.DOTALL | Pattern.MULTILINE);
    private static final Pattern FENCE = Pattern.compile("^[ \t>]*(```|~~~)", Pattern.MULTILINE);

    /** Path of the page below the project, with slashes. */
    public final String page;
    /** Text after the opening fence; may be empty. */
    public final String language;
    /** Lines between the fences, each with its line end, without the block's indentation. */
    public final String text;
    /** File name from the line before the block, or null. */
    public final String file;

    private DocBlock(String page, Matcher found) {
        this.page = page;
        this.file = found.group(1);
        this.language = found.group(3);
        this.text = found.group(4).replaceAll("(?m)^" + found.group(2), "");
    }

    /** Returns all pages, ordered by name. */
    public static List<String> pages() {
        try (Stream<Path> docs = Files.list(ROOT.resolve("docs"))) {
            TreeSet<String> pages = docs.map(file -> "docs/" + file.getFileName()).filter(page -> page.endsWith(".md"))
                .collect(Collectors.toCollection(TreeSet::new));
            pages.addAll(List.of("README.md", "CONTRIBUTING.md"));
            return List.copyOf(pages);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Returns the blocks of a page in order.
     * @throws AssertionError for a fence outside every block
     */
    public static List<DocBlock> of(String page) {
        try {
            String text = Files.readString(ROOT.resolve(page), StandardCharsets.UTF_8);
            List<DocBlock> blocks = new ArrayList<>();
            Matcher found = BLOCK.matcher(text);
            while (found.find()) {
                blocks.add(new DocBlock(page, found));
            }
            if (FENCE.matcher(text).results().count() != 2L * blocks.size()) {
                throw new AssertionError(page + " has a fence of another kind or one that is not closed; there are "
                    + blocks.size() + " blocks");
            }
            return blocks;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Returns the texts of the blocks of one language. */
    public static List<String> of(String page, String language) {
        return of(page).stream().filter(block -> block.language.equals(language)).map(block -> block.text)
            .collect(Collectors.toList());
    }

    /** Returns the command lines of a page that begin with a text. */
    public static List<String> commands(String page, String start) {
        return of(page, "sh").stream().flatMap(String::lines).filter(line -> line.startsWith(start))
            .collect(Collectors.toList());
    }

    @Override
    public String toString() {
        return page + " " + language;
    }
}
