package rasterlab.engine.plan;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.sight.ScreenAreas;

/**
 * Some of a scene's faces, evenly chosen, by which the work of all is estimated: what a picture
 * shows stays right whatever a sample says, only its cost is guessed by it.
 *
 * @param scene those faces with their vertices alone
 * @param weight how many faces each of them stands for; 1 where they are all
 * @param vertices of the whole mesh
 */
record SceneSample(Scene scene, double weight, int vertices) {
    /** Scenes of so many faces are taken whole. */
    private static final int FACES = 96;

    static SceneSample of(Scene scene) {
        Mesh mesh = scene.mesh();
        int all = mesh.faceCount();
        if (all <= FACES) return new SceneSample(scene, 1, mesh.vertexCount());
        int[] faces = new int[FACES];
        // Steps of the golden section do not keep time with a mesh's rows.
        double step = (Math.sqrt(5) - 1) / 2;
        for (int i = 0; i < FACES; i++)
            faces[i] = (int) Math.min(all - 1, (i + (i * step) % 1) * all / FACES);
        Scene part = scene.only(faces);
        int[] finishes = new int[FACES];
        for (int i = 0; i < FACES; i++) finishes[i] = part.finishNumber(i);
        var compact =
                new Scene(
                        scene.name(),
                        ownVertices(part.mesh()),
                        scene.finishes(),
                        finishes,
                        scene.light(),
                        scene.backgroundRgb(),
                        scene.defaultCamera(),
                        scene.pictureScale(),
                        scene.surfaces());
        return new SceneSample(compact, (double) all / FACES, mesh.vertexCount());
    }

    RequestView seen(RenderRequest request) {
        return RequestView.of(request.with(scene), request.width());
    }

    /**
     * @param closed whether the scene is one of closed bodies
     */
    ScreenAreas areas(RequestView seen, boolean closed) {
        return new ScreenAreas(seen.viewed(), weight, vertices, closed);
    }

    private static Mesh ownVertices(Mesh part) {
        Map<Integer, Integer> numbers = new HashMap<>();
        double[] xyz = new double[3 * part.totalCorners()];
        var corners = new int[part.faceCount()][];
        double[] normals = new double[part.hasNormals() ? xyz.length : 0];
        double[] texture = new double[part.hasTexture() ? 2 * part.totalCorners() : 0];
        double[] colors = new double[part.hasColors() ? xyz.length : 0];
        for (int f = 0; f < corners.length; f++) {
            corners[f] = new int[part.cornerCount(f)];
            for (int k = 0; k < corners[f].length; k++) {
                int v = part.corner(f, k);
                int own = numbers.computeIfAbsent(v, old -> numbers.size());
                corners[f][k] = own;
                xyz[3 * own] = part.x(v);
                xyz[3 * own + 1] = part.y(v);
                xyz[3 * own + 2] = part.z(v);
                int at = part.firstCorner(f) + k;
                for (int i = 0; i < 3; i++) {
                    if (normals.length > 0) normals[3 * at + i] = part.cornerNormal(f, k, i);
                    if (colors.length > 0) colors[3 * at + i] = part.color(f, k, i);
                }
                if (texture.length == 0) continue;
                texture[2 * at] = part.textureS(f, k);
                texture[2 * at + 1] = part.textureT(f, k);
            }
        }
        var mesh = new Mesh(Arrays.copyOf(xyz, 3 * numbers.size()), corners);
        if (normals.length > 0) mesh = mesh.withNormals(normals);
        if (texture.length > 0) mesh = mesh.withTexture(texture);
        return colors.length > 0 ? mesh.withColors(colors) : mesh;
    }
}
