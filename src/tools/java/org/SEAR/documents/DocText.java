// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import com.sun.source.doctree.DocTree;
import com.sun.source.doctree.EntityTree;
import com.sun.source.doctree.LinkTree;
import com.sun.source.doctree.LiteralTree;
import com.sun.source.doctree.StartElementTree;
import com.sun.source.doctree.TextTree;
import com.sun.source.doctree.UnknownBlockTagTree;
import java.util.List;
import java.util.Map;

/** Converts javadoc to Markdown: text, code, links to methods by name, paragraphs. */
final class DocText {
    private static final Map<String, String> ENTITIES = Map.of("lt", "<", "gt", ">", "amp", "&", "quot", "\"");

    private DocText() {
    }

    /** Returns the text on one line per paragraph. */
    static String of(List<? extends DocTree> trees) {
        StringBuilder out = new StringBuilder();
        boolean preformatted = false;
        for (DocTree tree : trees) {
            String text = text(tree);
            preformatted |= text.equals("<pre>");
            if (!preformatted) {
                out.append(tree instanceof TextTree ? text.replaceAll("\\s+", " ") : text);
            }
            preformatted &= !text.equals("</pre>");
        }
        return out.toString().replaceAll(" *\n\n *", "\n\n").trim();
    }

    /** Returns the raw text of a block tag. */
    static String raw(UnknownBlockTagTree tag) {
        StringBuilder out = new StringBuilder();
        tag.getContent().forEach(part -> out.append(part));
        return out.toString().trim();
    }

    private static String text(DocTree tree) {
        switch (tree.getKind()) {
            case TEXT:
                return ((TextTree) tree).getBody();
            case CODE:
                return "`" + ((LiteralTree) tree).getBody().getBody() + "`";
            case LITERAL:
                return ((LiteralTree) tree).getBody().getBody();
            case LINK:
            case LINK_PLAIN:
                return "`" + ((LinkTree) tree).getReference().getSignature().replaceAll("^.*[.#]", "") + "`";
            case ENTITY:
                return ENTITIES.getOrDefault(((EntityTree) tree).getName().toString(), tree.toString());
            case START_ELEMENT:
                String element = ((StartElementTree) tree).getName().toString();
                return element.equals("p") ? "\n\n" : "<" + element + ">";
            case END_ELEMENT:
                return tree.toString();
            default:
                throw new IllegalArgumentException("javadoc for scripts has " + tree
                    + ", legal: text, code, link, p, pre");
        }
    }
}
