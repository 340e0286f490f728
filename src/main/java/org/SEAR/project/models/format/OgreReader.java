// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.jme3.asset.AssetInfo;
import com.jme3.asset.AssetNotFoundException;
import com.jme3.material.Material;
import com.jme3.material.MaterialList;
import com.jme3.scene.Node;
import com.jme3.scene.plugins.ogre.matext.OgreMaterialKey;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import org.SEAR.files.FileLimits;
import org.SEAR.files.PrintableText;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;

/**
 * Reader of OGRE's XML meshes (OGRE, "ogremeshxml.dtd"): triangle lists, strips and fans in their rest pose. Levels of
 * detail, skeletons and poses are left out. One use.
 */
public final class OgreReader extends DefaultHandler {
    /** Elements that describe the surface. */
    private static final Set<String> READ = Set.of("mesh", "submeshes", "submesh", "sharedgeometry", "geometry",
        "vertexbuffer", "vertex",
        "position", "normal", "texcoord", "colour_diffuse", "faces", "face");
    private static final String XML = "the XML of an OGRE mesh";

    private final AssetInfo info;
    private final String file;
    private final Consumer<String> warnings;
    private Locator locator;
    /** Nested elements from the first one that is left out. */
    private int leftOut;
    private boolean hasMesh;
    private final List<OgreSubmesh> submeshes = new ArrayList<>();
    private OgreVertices shared;
    private OgreVertices vertices;
    private OgreSubmesh submesh;
    private long vertexCount;
    private long cornerCount;

    /** An error on its way through the parser. */
    private static final class Refused extends SAXException {
        private static final long serialVersionUID = 1;

        Refused(IOException why) {
            super(why);
        }
    }

    /** @param warnings receives each reason why the model is not shown as its file says */
    public OgreReader(AssetInfo info, Consumer<String> warnings) {
        this.info = info;
        this.file = info.getKey().getName();
        this.warnings = warnings;
    }

    /**
     * Returns the model, a mesh for each submesh.
     *
     * @param bytes XML without a document type
     * @throws IOException that names the line, the value and the legal values
     */
    public Node read(byte[] bytes) throws IOException {
        try {
            SAXParserFactory factory = SAXParserFactory.newInstance();
            factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
            factory.newSAXParser().parse(new InputSource(new ByteArrayInputStream(bytes)), this);
        } catch (Refused e) {
            throw (IOException) e.getException();
        } catch (SAXParseException e) {
            throw FileLimits.wrong(file, "the text before line " + e.getLineNumber() + ", column " + e.getColumnNumber()
                + ",",
                "no XML", XML, e);
        } catch (SAXException | ParserConfigurationException | IOException e) {
            throw FileLimits.wrong(file, "the text", "no XML in UTF-8", XML, e);
        }
        if (!hasMesh) {
            throw FileLimits.wrong(file, "<mesh>", "missing", XML);
        }
        return node();
    }

    private Node node() throws IOException {
        Node node = new Node(file);
        MaterialList materials = materials();
        Set<String> unknown = new TreeSet<>();
        long triangles = 0;
        for (OgreSubmesh each : submeshes) {
            if (each.hasSurface()) {
                SolidMesh mesh = each.mesh(file, shared);
                triangles += mesh.indices.length / 3;
                FileLimits.range(file, "the number of triangles", triangles, 0, ModelLimits.MAX_TRIANGLES);
                node.attachChild(SolidMesh.geometry("submesh in line " + each.line, mesh.mesh(), material(each.material,
                    materials, unknown)));
            }
        }
        if (!unknown.isEmpty()) {
            warnings.accept("its .material has no " + PrintableText.line(String.join(", ", unknown))
                + "; these submeshes are white");
        }
        return node;
    }

    /** Returns the materials beside the model; null if there are none. */
    private MaterialList materials() {
        String ending = "." + info.getKey().getExtension();
        try {
            return info.getManager().loadAsset(new OgreMaterialKey(file.substring(0, file.length() - ending.length())
                + ".material"));
        } catch (AssetNotFoundException e) {
            return null;
        }
    }

    private Material material(String name, MaterialList materials, Set<String> unknown) {
        Material known = name == null || materials == null ? null : materials.get(name);
        try {
            known = known == null && name != null && name.endsWith(".j3m") ? info.getManager().loadMaterial(name)
                : known;
        } catch (AssetNotFoundException e) {
            unknown.add(name);
        }
        if (known != null) {
            return known;
        }
        if (name != null && materials != null) {
            unknown.add(name);
        }
        return SolidMesh.white(info.getManager());
    }

    @Override
    public void setDocumentLocator(Locator given) {
        locator = given;
    }

    @Override
    public void startElement(String uri, String localName, String element, Attributes given) throws SAXException {
        if (leftOut > 0 || !READ.contains(element)) {
            leftOut++;
            return;
        }
        try {
            start(element, new OgreAttributes(file, element, locator.getLineNumber(), given));
        } catch (IOException e) {
            throw new Refused(e);
        }
    }

    private void start(String element, OgreAttributes given) throws IOException {
        switch (element) {
            case "mesh":
                hasMesh = true;
                break;
            case "submesh":
                submesh = new OgreSubmesh(given);
                submeshes.add(submesh);
                FileLimits.range(file, "the number of submeshes up to line " + given.line, submeshes.size(), 1,
                    ModelLimits.MAX_NODES - 1);
                break;
            case "sharedgeometry":
            case "geometry":
                vertices = vertices(element, given);
                break;
            case "vertexbuffer":
                given.require(vertices != null, "in a geometry");
                vertices.startBuffer();
                break;
            case "faces":
                given.require(submesh != null, "in a submesh");
                submesh.state(given);
                break;
            case "face":
                given.require(submesh != null, "in the faces of a submesh");
                cornerCount += submesh.addFace(given);
                FileLimits.range(file, "the number of corners of faces up to line " + given.line, cornerCount, 0,
                    3L * ModelLimits.MAX_TRIANGLES);
                break;
            default:
                if (!element.equals("submeshes")) {
                    given.require(vertices != null, "in a geometry");
                    vertices.add(element, given);
                }
        }
    }

    private OgreVertices vertices(String element, OgreAttributes given) throws IOException {
        OgreVertices made = new OgreVertices(given);
        vertexCount += made.count;
        FileLimits.range(file, "the number of vertices up to line " + given.line, vertexCount, 0,
            ModelLimits.MAX_TRIANGLES);
        if (element.equals("sharedgeometry")) {
            shared = made;
        } else {
            given.require(submesh != null, "in a submesh");
            submesh.own = made;
        }
        return made;
    }

    @Override
    public void endElement(String uri, String localName, String element) throws SAXException {
        if (leftOut > 0) {
            leftOut--;
            return;
        }
        try {
            if (element.equals("geometry") || element.equals("sharedgeometry")) {
                vertices.end(file);
                vertices = null;
            } else if (element.equals("submesh")) {
                submesh.end(file);
                submesh = null;
            }
        } catch (IOException e) {
            throw new Refused(e);
        }
    }
}
