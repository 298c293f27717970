package rasterlab.exercises.scene;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.SphericalView;

/** A whole scene as JSON: vertices, faces, finishes, light, background, first view. */
final class InlineScene {
    private static final int HIGHEST_RGB = 0xFFFFFF;
    private static final double LARGEST = 1e30;
    private static final SphericalView CAMERA =
            new SphericalView(Math.PI / 6, Math.PI * 7 / 18, 500);

    private InlineScene() {}

    static Scene read(SceneJsonPlace scene) {
        scene.object(
                "name", "vertices", "faces", "finishes", "light", "background", "pictureScale");
        List<SceneJsonPlace> faces = scene.at("faces").members();
        List<Appearance> finishes =
                scene.at("finishes").members().stream().map(FinishJson::read).toList();
        if (finishes.isEmpty() && !faces.isEmpty())
            throw scene.at("finishes").wrong("must not be empty where there are faces");
        int[] finishOf =
                faces.stream()
                        .mapToInt(
                                face ->
                                        face.object(
                                                        "corners", "finish", "normals", "texture",
                                                        "colors")
                                                .at("finish")
                                                .integer(0, finishes.size() - 1))
                        .toArray();
        Mesh mesh = mesh(scene, faces);
        return scene.made(
                place ->
                        new Scene(
                                place.at("name").text(),
                                mesh,
                                finishes,
                                finishOf,
                                LightJson.read(place.at("light")),
                                place.at("background").integer(0, HIGHEST_RGB),
                                CAMERA,
                                place.at("pictureScale").number(1e-30, LARGEST)));
    }

    private static Mesh mesh(SceneJsonPlace scene, List<SceneJsonPlace> faces) {
        double[] xyz =
                scene.at("vertices").members().stream()
                        .map(vertex -> vertex.numbers(3, -LARGEST, LARGEST))
                        .flatMapToDouble(Arrays::stream)
                        .toArray();
        int[][] corners = new int[faces.size()][];
        for (int f = 0; f < corners.length; f++)
            corners[f] =
                    faces.get(f).at("corners").members().stream()
                            .mapToInt(corner -> corner.integer(0, xyz.length / 3 - 1))
                            .toArray();
        Mesh bare = scene.at("faces").made(place -> new Mesh(xyz, corners));
        Mesh shaded =
                has(scene, faces, "normals")
                        ? scene.at("faces")
                                .made(p -> bare.withNormals(all(faces, "normals", 3, corners)))
                        : bare;
        Mesh textured =
                has(scene, faces, "texture")
                        ? shaded.withTexture(all(faces, "texture", 2, corners))
                        : shaded;
        return has(scene, faces, "colors")
                ? scene.at("faces").made(p -> textured.withColors(all(faces, "colors", 3, corners)))
                : textured;
    }

    private static boolean has(SceneJsonPlace scene, List<SceneJsonPlace> faces, String field) {
        long with = faces.stream().filter(face -> face.has(field)).count();
        if (with != 0 && with != faces.size())
            throw scene.at("faces")
                    .wrong(
                            "'%s' must be in all faces or in none, got it in %d of %d"
                                    .formatted(field, with, faces.size()));
        return with > 0;
    }

    /** The numbers of all corners. */
    private static double[] all(
            List<SceneJsonPlace> faces, String field, int each, int[][] corners) {
        var numbers = DoubleStream.builder();
        for (int f = 0; f < corners.length; f++) {
            List<SceneJsonPlace> of = faces.get(f).at(field).members();
            if (of.size() != corners[f].length)
                throw faces.get(f)
                        .at(field)
                        .wrong(
                                "must have one for each of %d corners, got %d"
                                        .formatted(corners[f].length, of.size()));
            for (SceneJsonPlace one : of)
                for (double number : one.numbers(each, -LARGEST, LARGEST)) numbers.add(number);
        }
        return numbers.build().toArray();
    }

    static void write(Scene scene, ObjectNode out) {
        out.put("name", scene.name());
        Mesh mesh = scene.mesh();
        ArrayNode vertices = out.putArray("vertices");
        for (int v = 0; v < mesh.vertexCount(); v++)
            vertices.addArray().add(mesh.x(v)).add(mesh.y(v)).add(mesh.z(v));
        ArrayNode faces = out.putArray("faces");
        int[] finishOf = scene.finishOf();
        for (int f = 0; f < mesh.faceCount(); f++) {
            ObjectNode face = faces.addObject();
            writeCorners(mesh, f, face);
            face.put("finish", finishOf[f]);
        }
        ArrayNode finishes = out.putArray("finishes");
        scene.finishes().forEach(finish -> FinishJson.write(finish, finishes.addObject()));
        LightJson.write(scene.light(), out.putObject("light"));
        out.put("background", scene.backgroundRgb());
        out.put("pictureScale", scene.pictureScale());
    }

    private static void writeCorners(Mesh mesh, int f, ObjectNode face) {
        ArrayNode corners = face.putArray("corners");
        for (int k = 0; k < mesh.cornerCount(f); k++) corners.add(mesh.corner(f, k));
        if (mesh.hasNormals()) {
            ArrayNode normals = face.putArray("normals");
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                ArrayNode normal = normals.addArray();
                for (int axis = 0; axis < 3; axis++) normal.add(mesh.cornerNormal(f, k, axis));
            }
        }
        if (mesh.hasTexture()) {
            ArrayNode texture = face.putArray("texture");
            for (int k = 0; k < mesh.cornerCount(f); k++)
                texture.addArray().add(mesh.textureS(f, k)).add(mesh.textureT(f, k));
        }
        if (mesh.hasColors()) {
            ArrayNode colors = face.putArray("colors");
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                ArrayNode color = colors.addArray();
                for (int channel = 0; channel < 3; channel++) color.add(mesh.color(f, k, channel));
            }
        }
    }
}
