// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.TreeMap;
import org.SEAR.POJOs.Model;
import org.SEAR.files.Assets;
import org.SEAR.geometry.Triangles;

/** A small whole model in each format, for tests that change them. */
public final class MutableModels {
    private MutableModels() {
    }

    /** Returns the models by file name extension. */
    public static TreeMap<String, byte[]> all() throws IOException {
        TreeMap<String, byte[]> all = new TreeMap<>();
        for (String ending : ModelLoader.ENDINGS) {
            all.put(ending, BrokenModels.TRIANGLE.bytes(ending));
        }
        all.put("2.obj", ("mtllib m.mtl\ng a\nusemtl red\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0 # in\nv 0 2 0 1 1 "
            + "1\nvt 0 0\nvn 0 0 1\n"
            + "f 1/1/1 2//1 3/-1 4 \\\n 5\nusemtl\nf -1 -2 -3\n").getBytes(StandardCharsets.UTF_8));
        GltfFile gltf = GltfFile.cube();
        int joints = gltf.numbers(5121, 4, "", new double[32]);
        int weights = gltf.floats(4, new double[32]);
        int normals = gltf.numbers(5120, 3, ",\"normalized\":true", new double[24]);
        int sparse = gltf.accessor("\"componentType\":5126,\"count\":8,\"type\":\"VEC3\",\"sparse\":{\"count\":1,"
            + "\"indices\":{\"bufferView\":" + gltf.view(5121, 3) + ",\"componentType\":5121},"
            + "\"values\":{\"bufferView\":" + gltf.view(5126, 1, 2, 3) + "}}");
        gltf.primitive("\"attributes\":{\"POSITION\":0,\"NORMAL\":" + normals + ",\"JOINTS_0\":" + joints
            + ",\"WEIGHTS_0\":" + weights
            + "},\"indices\":1,\"targets\":[{\"POSITION\":" + sparse + "}],\"material\":0").mesh(",\"weights\":[0.5]");
        gltf.primitive("\"attributes\":{\"POSITION\":0},\"mode\":5,\"indices\":1");
        gltf.node("\"mesh\":0,\"skin\":0").node("\"matrix\":[1,0,0,0,2,1,0,0,0,0,1,0,5,6,7,1],\"mesh\":0").roots("0,1");
        gltf.with(",\"skins\":[{\"joints\":[1]}],"
            + "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,0,1],"
            + "\"baseColorTexture\":{\"index\":0}}}],\"textures\":[{\"source\":0,\"sampler\":0}],"
            + "\"samplers\":[{\"wrapS\":33071}],\"images\":[{\"uri\":\"data:image/png;base64,iVBORw0KGgo=\"}]");
        all.put("2.gltf", gltf.bytes());
        String vertex = "<vertex><position x='1' y='2' z='3'/><normal x='0' y='0' z='1'/><texcoord u='0' "
            + "v='1'/></vertex>";
        all.put("2.mesh.xml", ("<mesh><sharedgeometry vertexcount='4'>"
            + "<vertexbuffer positions='true' normals='true' texture_coords='1'>" + vertex.repeat(4)
            + "</vertexbuffer></sharedgeometry>"
            + "<submeshes><submesh material='a' usesharedvertices='true' operationtype='triangle_strip'>"
            + "<faces count='2'><face v1='0' v2='1' v3='2'/><face v1='3'/></faces>"
            + "</submesh></submeshes><skeletonlink name='b'/></mesh>").getBytes(StandardCharsets.UTF_8));
        all.put("2.stl", StlFormatTest.TEXT.getBytes(StandardCharsets.UTF_8));
        all.put("2.ply", PlyFormatTest.PAINTED.getBytes(StandardCharsets.UTF_8));
        all.put("2.dae", ColladaFormatTest.PAINTED.getBytes(StandardCharsets.UTF_8));
        return all;
    }

    /** Returns the triangles of a model in a project folder. */
    public static Triangles load(Path folder, Model model) throws IOException {
        return ModelLoader.withoutPictures(new Assets(folder.resolve("assets")), warning -> { }).triangles(model);
    }
}
