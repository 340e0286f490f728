// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.xml;

import com.thoughtworks.xstream.XStream;
import com.thoughtworks.xstream.XStreamException;
import com.thoughtworks.xstream.converters.DataHolder;
import com.thoughtworks.xstream.converters.reflection.ReflectionProviderWrapper;
import com.thoughtworks.xstream.core.ClassLoaderReference;
import com.thoughtworks.xstream.core.MapBackedDataHolder;
import com.thoughtworks.xstream.io.HierarchicalStreamReader;
import com.thoughtworks.xstream.io.xml.PrettyPrintWriter;
import com.thoughtworks.xstream.io.xml.QNameMap;
import com.thoughtworks.xstream.io.xml.StaxDriver;
import com.thoughtworks.xstream.io.xml.StaxReader;
import com.thoughtworks.xstream.mapper.ClassAliasingMapper;
import com.thoughtworks.xstream.mapper.DefaultMapper;
import com.thoughtworks.xstream.mapper.SecurityMapper;
import com.thoughtworks.xstream.security.NoTypePermission;
import java.io.IOException;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamException;
import org.SEAR.project.problems.ProblemList;

/**
 * XML files of single objects: an element named like the class contains an element for each parameter. Reading allows
 * the named classes only, and no attributes, references, entities or document types. It reports all problems.
 */
public final class Xml {
    /** Largest legal size of a file, bytes; a hand-written object has a few kilobytes. */
    public static final int MAX_BYTES = 1 << 20;
    private static final String HEADER = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

    /** XStream by the classes that it may create; creating one takes longer than reading a file. */
    private static final Map<Set<Class<?>>, XStream> XSTREAMS = new ConcurrentHashMap<>();

    /** Factory of each thread, since the factory is not thread-safe. */
    private static final ThreadLocal<XMLInputFactory> FACTORIES = ThreadLocal.withInitial(Xml::inputFactory);

    private Xml() {
    }

    /**
     * XStream without its built-in converters and reflection. The converters took a quarter of the time in which a
     * fresh JVM opens a thousand objects. The reflection provider probes the JVM and thereby loads the names of all
     * time zones, a twentieth of the processor time until a script's first reading.
     */
    private static final class GrammarStream extends XStream {
        GrammarStream() {
            this(new ClassLoaderReference(Xml.class.getClassLoader()));
        }

        private GrammarStream(ClassLoaderReference loader) {
            super(new ReflectionProviderWrapper(null), new StaxDriver(), loader,
                new SecurityMapper(new ClassAliasingMapper(new DefaultMapper(loader))));
        }

        @Override
        protected void setupSecurity() {
            // only the grammar's classes are allowed
        }

        @Override
        protected void setupConverters() {
            registerConverter(new GrammarConverter(), PRIORITY_VERY_HIGH);
        }

        @Override
        protected void setupAliases() {
            // each class of the grammar gets its own alias
        }

        @Override
        protected void setupDefaultImplementations() {
            // the grammar has no interfaces
        }

        @Override
        protected void setupImmutableTypes() {
            // objects are written without references
        }
    }

    private static XStream xstream(Map<String, ? extends Class<?>> classes) {
        return XSTREAMS.computeIfAbsent(Set.copyOf(classes.values()), key -> newXStream(classes));
    }

    private static XStream newXStream(Map<String, ? extends Class<?>> classes) {
        XStream xstream = new GrammarStream();
        xstream.addPermission(NoTypePermission.NONE);
        xstream.setMode(XStream.NO_REFERENCES);
        classes.forEach((element, type) -> {
            xstream.allowTypes(new Class<?>[] {type});
            xstream.alias(element, type);
        });
        return xstream;
    }

    /** Returns the text of an object's file; the same object gives the same bytes. */
    public static String write(Object object) {
        StringWriter text = new StringWriter();
        text.write(HEADER);
        String element = object.getClass().getSimpleName();
        PrettyPrintWriter writer = new PrettyPrintWriter(text);
        xstream(Map.of(element, object.getClass())).marshal(object, writer);
        writer.flush();
        return text + "\n";
    }

    /**
     * Reads a file.
     *
     * @param name of the file in problems
     * @param classes the legal root elements
     * @return null if the file can't be read; {@code problems} has the reason
     */
    public static ParsedObject read(Path file, String name, Map<String, ? extends Class<?>> classes,
        ProblemList problems) {
        try {
            if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
                problems.add(name, 0, "", "it is no ordinary file", "an XML file, neither a link nor a folder");
                return null;
            }
            long size = Files.size(file);
            if (size > MAX_BYTES) {
                problems.add(name, 0, "", "it has " + size + " bytes", "at most " + MAX_BYTES + " bytes");
                return null;
            }
            return parse(Files.readAllBytes(file), name, classes, problems);
        } catch (IOException e) {
            problems.add(name, 0, "", "it can't be read (" + e + ")", "a readable file");
            return null;
        }
    }

    /**
     * Reads an object from bytes, see {@link #read}.
     *
     * @return null if the bytes can't be read; {@code problems} has the reason
     */
    public static ParsedObject parse(byte[] bytes, String name, Map<String, ? extends Class<?>> classes,
        ProblemList problems) {
        String text;
        try {
            text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
        } catch (CharacterCodingException e) {
            problems.add(name, 0, "", "it is not text in UTF-8", "XML in UTF-8");
            return null;
        }
        if (text.startsWith("\ufeff")) {
            text = text.substring(1);
        }
        try {
            return unmarshal(text, name, classes, problems);
        } catch (XMLStreamException e) {
            reportBroken(name, text, e, problems);
        } catch (XStreamException e) {
            XMLStreamException broken = xmlError(e);
            if (broken != null) {
                reportBroken(name, text, broken, problems);
            } else {
                problems.add(name, 0, "", "it can't be read (" + firstLine(e) + ")", "an object of the grammar");
            }
        }
        return null;
    }

    private static XMLStreamException xmlError(Throwable e) {
        Throwable cause = e;
        while (cause != null && !(cause instanceof XMLStreamException)) {
            cause = cause.getCause();
        }
        return (XMLStreamException) cause;
    }

    private static ParsedObject unmarshal(String text, String name, Map<String, ? extends Class<?>> classes,
        ProblemList problems) throws XMLStreamException {
        StrictXmlStream stream = new StrictXmlStream(FACTORIES.get().createXMLStreamReader(new StringReader(text)));
        HierarchicalStreamReader reader = new StaxReader(new QNameMap(), stream);
        String root = reader.getNodeName();
        int line = LineNumber.line(reader);
        if (!classes.containsKey(root)) {
            problems.add(name, line, "", "<" + root + "> is not an object here", String.join(", ", classes.keySet()));
            return null;
        }
        int before = problems.size();
        ObjectReader elements = new ObjectReader(name, problems);
        DataHolder context = new MapBackedDataHolder();
        context.put(ObjectReader.class, elements);
        Object object = xstream(classes).unmarshal(new RootWithoutAttributes(reader, name, line, problems),
            null, context);
        if (!problems.isFull()) {
            stream.finish();
        }
        return problems.size() > before ? ParsedObject.broken(name, line)
            : new ParsedObject(object, name, line, elements.lines());
    }

    private static XMLInputFactory inputFactory() {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        factory.setProperty(XMLInputFactory.IS_NAMESPACE_AWARE, false);
        return factory;
    }

    private static void reportBroken(String name, String text, XMLStreamException e, ProblemList problems) {
        int line = e.getLocation() == null ? 0 : e.getLocation().getLineNumber();
        String said = firstLine(e);
        if (said.contains("Premature end of file")) {
            problems.add(name, Math.max(1, line), "", "the file holds no object",
                "an object such as <Box>, with all its elements");
            return;
        }
        if (isCutOff(text, e, said)) {
            problems.add(name, Math.max(1, line), "", "the file ends in the middle",
                "the whole file, with the closing tag of its first element (was it copied or saved only in part?)");
            return;
        }
        int message = said.indexOf("Message: ");
        problems.add(name, line, "", message < 0 ? said : said.substring(message + "Message: ".length()),
            "well-formed XML without document type");
    }

    /**
     * Returns whether the parser stopped because the text is incomplete. The JDK's parser has many messages for this
     * case, always with a position at the end of the text.
     */
    private static boolean isCutOff(String text, XMLStreamException e, String said) {
        boolean atEnd = e.getLocation() != null && e.getLocation().getCharacterOffset() >= text.length();
        return atEnd && !text.trim().endsWith(">") || said.contains("must start and end within the same entity");
    }

    private static String firstLine(Exception e) {
        String said = String.valueOf(e.getMessage()).replace('\r', ' ');
        int message = said.indexOf("Message: ");
        String rest = message < 0 ? said : said.substring(message);
        int end = rest.indexOf('\n');
        return end < 0 ? rest : rest.substring(0, end);
    }
}
