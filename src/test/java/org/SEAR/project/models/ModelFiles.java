// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import com.jme3.export.binary.BinaryExporter;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.Node;
import com.jme3.scene.VertexBuffer;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import org.SEAR.project.ProjectRule;

/** Writes one solid in any of the model formats. */
final class ModelFiles {
    private final float[] corners;
    private final int[] indices;
    private final float[] place;

    /**
     * @param corners x, y, z of each vertex
     * @param indices three vertex numbers per triangle
     * @param place offset of the solid, set in a node if the format has nodes, else in the vertices
     */
    ModelFiles(float[] corners, int[] indices, float... place) {
        this.corners = corners;
        this.indices = indices;
        this.place = place;
    }

    /**
     * Writes {@code assets/m.ENDING} into a project.
     * @return the path for {@code Model}
     */
    String put(ProjectRule project, String ending) throws IOException {
        Path assets = project.folder().resolve("assets");
        Files.createDirectories(assets);
        Files.write(assets.resolve("m" + ending), bytes(ending));
        return "m" + ending;
    }

    byte[] bytes(String ending) throws IOException {
        switch (ending) {
            case ".mesh.xml":
                return ogre().getBytes(StandardCharsets.UTF_8);
            case ".j3o":
                return j3o();
            case ".obj":
                return obj().getBytes(StandardCharsets.UTF_8);
            case ".gltf":
                return gltf("\"uri\":\"data:application/octet-stream;base64," + Base64.getEncoder()
                    .encodeToString(buffer()) + "\",").getBytes(StandardCharsets.UTF_8);
            case ".glb":
                return glb();
            case ".blend":
                return blend();
            case ".stl":
                return stl();
            case ".ply":
                return ply();
            case ".dae":
                return dae().getBytes(StandardCharsets.UTF_8);
            default:
                throw new IllegalArgumentException(ending);
        }
    }

    private float moved(int i) {
        return corners[i] + place[i % 3];
    }

    private String obj() {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < corners.length; i += 3) {
            text.append("v " + moved(i) + " " + moved(i + 1) + " " + moved(i + 2) + "\n");
        }
        for (int i = 0; i < indices.length; i += 3) {
            text.append("f " + (indices[i] + 1) + " " + (indices[i + 1] + 1) + " " + (indices[i + 2] + 1) + "\n");
        }
        return text.toString();
    }

    private String ogre() {
        StringBuilder text = new StringBuilder(
            "<mesh><submeshes><submesh material=\"none\" usesharedvertices=\"false\" use32bitindexes=\"false\""
            + " operationtype=\"triangle_list\"><faces count=\"" + indices.length / 3 + "\">");
        for (int i = 0; i < indices.length; i += 3) {
            text.append("<face v1=\"" + indices[i] + "\" v2=\"" + indices[i + 1] + "\" v3=\""
                + indices[i + 2] + "\"/>");
        }
        text.append("</faces><geometry vertexcount=\"" + corners.length / 3 + "\"><vertexbuffer positions=\"true\">");
        for (int i = 0; i < corners.length; i += 3) {
            text.append("<vertex><position x=\"" + moved(i) + "\" y=\"" + moved(i + 1) + "\" z=\"" + moved(i + 2)
                + "\"/></vertex>");
        }
        return text + "</vertexbuffer></geometry></submesh></submeshes></mesh>";
    }

    private byte[] j3o() throws IOException {
        Mesh mesh = new Mesh();
        mesh.setBuffer(VertexBuffer.Type.Position, 3, corners);
        mesh.setBuffer(VertexBuffer.Type.Index, 3, indices);
        mesh.updateBound();
        Node root = new Node("root");
        root.attachChild(new Geometry("solid", mesh));
        root.setLocalTranslation(place[0], place[1], place[2]);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        BinaryExporter.getInstance().save(root, out);
        return out.toByteArray();
    }

    private byte[] buffer() {
        ByteBuffer buffer = ByteBuffer.allocate((corners.length + indices.length) * 4).order(ByteOrder.LITTLE_ENDIAN);
        for (float value : corners) {
            buffer.putFloat(value);
        }
        for (int value : indices) {
            buffer.putInt(value);
        }
        return buffer.array();
    }

    private String gltf(String uri) {
        float[] low = corners.clone();
        float[] high = corners.clone();
        for (int i = 0; i < corners.length; i++) {
            low[i % 3] = Math.min(low[i % 3], corners[i]);
            high[i % 3] = Math.max(high[i % 3], corners[i]);
        }
        return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,"
            + "\"translation\":["
            + triple(place) + "]}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],"
            + "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":" + corners.length / 3
            + ",\"type\":\"VEC3\",\"min\":[" + triple(low)
            + "],\"max\":[" + triple(high) + "]},{\"bufferView\":1,\"componentType\":5125,\"count\":" + indices.length
            + ",\"type\":\"SCALAR\"}],"
            + "\"bufferViews\":[{\"buffer\":0,\"byteLength\":" + corners.length * 4 + "},{\"buffer\":0,\"byteOffset\":"
            + corners.length * 4
            + ",\"byteLength\":" + indices.length * 4 + "}],\"buffers\":[{" + uri + "\"byteLength\":"
            + buffer().length + "}]}";
    }

    private static String triple(float[] values) {
        return values[0] + "," + values[1] + "," + values[2];
    }

    private byte[] glb() {
        byte[] json = gltf("").getBytes(StandardCharsets.UTF_8);
        byte[] buffer = buffer();
        int padded = (json.length + 3) / 4 * 4;
        ByteBuffer glb = ByteBuffer.allocate(12 + 8 + padded + 8 + buffer.length).order(ByteOrder.LITTLE_ENDIAN);
        glb.putInt(0x46546c67).putInt(2).putInt(glb.capacity()).putInt(padded).putInt(0x4e4f534a).put(json);
        while (glb.position() < 20 + padded) {
            glb.put((byte) ' ');
        }
        return glb.putInt(buffer.length).putInt(0x004e4942).put(buffer).array();
    }

    private byte[] stl() {
        ByteBuffer stl = ByteBuffer.allocate(84 + 50 * indices.length / 3).order(ByteOrder.LITTLE_ENDIAN);
        stl.position(80);
        stl.putInt(indices.length / 3);
        for (int i = 0; i < indices.length; i++) {
            stl.position(84 + i / 3 * 50 + 12 + i % 3 * 12);
            for (int axis = 0; axis < 3; axis++) {
                stl.putFloat(moved(3 * indices[i] + axis));
            }
        }
        return stl.array();
    }

    private byte[] ply() {
        byte[] head = ("ply\nformat binary_big_endian 1.0\nelement vertex " + corners.length / 3 + "\n"
            + "property float x\nproperty float y\nproperty float z\nelement face " + indices.length / 3 + "\n"
            + "property list uchar int vertex_indices\nend_header\n").getBytes(StandardCharsets.UTF_8);
        ByteBuffer ply = ByteBuffer.allocate(head.length + 4 * corners.length + 13 * indices.length / 3);
        ply.put(head);
        for (int i = 0; i < corners.length; i++) {
            ply.putFloat(moved(i));
        }
        for (int i = 0; i < indices.length; i++) {
            if (i % 3 == 0) {
                ply.put((byte) 3);
            }
            ply.putInt(indices[i]);
        }
        return ply.array();
    }

    /** In centimetres, z up, with a node. */
    private String dae() {
        StringBuilder numbers = new StringBuilder();
        for (int i = 0; i < corners.length; i += 3) {
            numbers.append(100 * corners[i]).append(' ').append(-100 * corners[i + 2]).append(' ')
                .append(100 * corners[i + 1]).append(' ');
        }
        StringBuilder p = new StringBuilder();
        for (int index : indices) {
            p.append(index).append(' ');
        }
        return "<COLLADA version='1.4.1'><asset><unit meter='0.01'/><up_axis>Z_UP</up_axis></asset><library_geometries>"
            + "<geometry id='g'><mesh><source id='s'><float_array id='a' count='" + corners.length + "'>" + numbers
            + "</float_array><technique_common><accessor source='#a' count='" + corners.length / 3 + "' stride='3'>"
            + "<param name='X' type='float'/><param name='Y' type='float'/><param name='Z' type='float'/></accessor>"
            + "</technique_common></source><vertices id='v'><input semantic='POSITION' source='#s'/></vertices>"
            + "<triangles count='" + indices.length / 3 + "'><input semantic='VERTEX' source='#v' offset='0'/><p>" + p
            + "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id='w'>"
            + "<node><translate>" + 100 * place[0] + " " + -100 * place[2] + " " + 100 * place[1]
            + "</translate><instance_geometry url='#g'/></node></visual_scene></library_visual_scenes>"
            + "<scene><instance_visual_scene url='#w'/></scene></COLLADA>";
    }

    /** In Blender z points up, and -y is SEAR's +z. */
    private byte[] blend() {
        float[] turned = new float[corners.length];
        for (int i = 0; i < corners.length; i += 3) {
            turned[i] = corners[i];
            turned[i + 1] = -corners[i + 2];
            turned[i + 2] = corners[i + 1];
        }
        int[][] polygons = new int[indices.length / 3][3];
        for (int i = 0; i < indices.length; i++) {
            polygons[i / 3][i % 3] = indices[i];
        }
        return BlendFile.mesh(turned, polygons, new float[] {place[0], -place[2], place[1]});
    }
}
