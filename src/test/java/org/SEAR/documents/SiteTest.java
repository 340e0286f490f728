// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.Slow;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/**
 * Links between pages, including links to headings, and the site that scripts/site makes. With -Pfull the whole site is
 * built.
 */
@Category(Slow.class)
public class SiteTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final boolean FULL = Boolean.getBoolean("sear.full");
    private static final long PATIENCE_MINUTES = 10;
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#\\s:]*)#([^)\\s]+)\\)");
    private static final Pattern HEADING = Pattern.compile("(?m)^#+ (.*)$");
    private static final Pattern ELSEWHERE =
        Pattern.compile("<(?:script|link|img|iframe)[^>]*(?:src|href)=\"?(?:https?:)?//");

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private static String text(Path page) throws IOException {
        return Files.readString(page).replaceAll("(?s)```.*?```", "");
    }

    /** Returns GitHub's anchors of the headings. */
    private static Set<String> headings(Path page) throws IOException {
        Set<String> found = new TreeSet<>();
        Matcher heading = HEADING.matcher(text(page));
        while (heading.find()) {
            String words = heading.group(1).replaceAll("\\[([^\\]]*)\\]\\([^)]*\\)", "$1").trim()
                .toLowerCase(Locale.ROOT);
            String slug = words.replaceAll("[^\\p{L}\\p{N}_\\- ]", "").replace(' ', '-');
            int again = 1;
            String name = slug;
            while (!found.add(name)) {
                name = slug + "-" + again++;
            }
        }
        return found;
    }

    @Test
    public void everyLinkToAHeadingFindsIt() throws IOException {
        List<String> broken = new ArrayList<>();
        int links = 0;
        for (String name : DocBlock.pages()) {
            Path page = ROOT.resolve(name);
            Matcher link = LINK.matcher(text(page).replaceAll("`[^`\n]*`", ""));
            while (link.find()) {
                Path to = link.group(1).isEmpty() ? page : page.resolveSibling(link.group(1)).normalize();
                links++;
                if (!Files.isRegularFile(to) || !headings(to).contains(link.group(2))) {
                    broken.add(name + " -> " + link.group());
                }
            }
        }
        assertEquals("[]", broken.toString());
        assertTrue(links + " links", links > 100);
    }

    /** Returns the output of the command, which must end with this status. */
    private String make(int status, Path root, Path pages, Path site, String... more)
        throws IOException, InterruptedException {
        Path output = temporary.newFile().toPath();
        List<String> command = new ArrayList<>(
            List.of("python3", ROOT.resolve("scripts/site").toString(), pages.toString(), site.toString()));
        command.addAll(List.of(more));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(output.toFile());
        builder.environment().put("PYTHONPATH", System.getProperty("sear.mkdocs"));
        builder.environment().put("SEAR_ROOT", root.toString());
        Process process = builder.start();
        try {
            assertTrue(Files.readString(output), process.waitFor(PATIENCE_MINUTES, TimeUnit.MINUTES));
        } finally {
            process.destroyForcibly();
        }
        assertEquals(Files.readString(output), status, process.exitValue());
        return Files.readString(output);
    }

    @Test
    public void theSiteHasAllPagesByTheirQuestions() throws Exception {
        Path pages = temporary.getRoot().toPath().resolve("pages");
        Path site = temporary.getRoot().toPath().resolve("site");
        make(0, ROOT, pages, site, FULL ? new String[0] : new String[] {"--pages-only"});
        String list = Files.readString(temporary.getRoot().toPath().resolve("pages.yml"));
        assertTrue(list, list.contains("\"... use Python 3 and numpy?\": docs/python3.md"));
        for (String page : DocBlock.pages()) {
            String name = page.equals("README.md") ? "index.md" : page;
            assertTrue(name, Files.exists(pages.resolve(name)) && list.contains(": " + name + "\n"));
            if (FULL) {
                String html = Files.readString(site.resolve(name.replaceAll("md$", "html")));
                assertFalse(name + " takes something from elsewhere",
                    ELSEWHERE.matcher(html.replaceAll("<link rel=\"?canonical[^>]*>", "")).find());
            }
        }
        assertTrue(Files.exists(pages.resolve("docs/images/office.png"))
            && Files.exists(pages.resolve("examples/maze.py")));
    }

    @Test
    public void aBrokenLinkIsReported() throws Exception {
        Path root = temporary.newFolder().toPath();
        Files.createDirectories(root.resolve("docs"));
        for (String page : List.of("README.md", "CONTRIBUTING.md", "CHANGELOG.md")) {
            Files.writeString(root.resolve(page), "# " + page + "\n\n| | |\n|---|---|\n| do it? | "
                + "[it](docs/it.md) |\n");
        }
        Files.writeString(root.resolve("docs/it.md"), "# It\n\n[![gone](gone.png)](../README.md), [here](#it), "
            + "`[code](no.md)`\n");
        Path pages = root.resolve("pages");
        assertEquals("docs/it.md links to gone.png, which does not exist\n",
            make(1, root, pages, root.resolve("site"), "--pages-only"));
        Files.writeString(root.resolve("docs/it.md"), "# It\n\n[here](#it), [there](../README.md#nowhere)\n");
        if (FULL) {
            String told = make(1, root, pages, root.resolve("site"));
            assertTrue(told, told.contains("nowhere"));
        } else {
            assertEquals("", make(0, root, pages, root.resolve("site"), "--pages-only"));
        }
        try (Stream<Path> written = Files.walk(pages)) {
            assertEquals(4, written.filter(file -> file.toString().endsWith(".md"))
                .collect(Collectors.toList()).size());
        }
    }
}
