package rasterlab.engine.pipeline.direct;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.contract.LightSource;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.catalogue.Scenes;

/** The faces that are kept of a scene for its next picture. */
class PackedSceneTest {
    @Test
    @DisplayName("a picture is drawn of the faces, finishes or corners of the one before")
    void eachPictureIsTheOneOfAFreshRenderer() {
        Scene torus = striped(Scenes.named("torus"), 0);
        List<RenderRequest> requests =
                List.of(
                        request(torus, ShadingMethod.GOURAUD),
                        request(torus, ShadingMethod.FLAT),
                        request(striped(torus, 1), ShadingMethod.FLAT),
                        request(striped(torus, 1), ShadingMethod.GOURAUD),
                        request(torus, ShadingMethod.PHONG),
                        request(Scenes.named("cube"), ShadingMethod.GOURAUD),
                        request(torus, ShadingMethod.GOURAUD));
        try (var used = new Renderer()) {
            for (RenderRequest request : requests)
                try (var fresh = new Renderer()) {
                    assertArrayEquals(
                            fresh.render(request, () -> false).argb(),
                            used.render(request, () -> false).argb(),
                            request.scene().name() + ", " + request.look().shading());
                }
        }
    }

    @Test
    @DisplayName("each corner of a smooth mesh is a vertex of its own, or flat faces share theirs")
    void cornersThatAreAlikeShareAVertex() {
        Mesh cube = Scenes.named("cube").mesh();
        int[] faces = IntStream.range(0, cube.faceCount()).toArray();
        assertEquals(24, PackedFaces.shared(cube, faces).triangles().vertexCount());
        double[] upwards = new double[3 * cube.totalCorners()];
        for (int c = 0; c < cube.totalCorners(); c++) upwards[3 * c + 2] = 1;
        Mesh alike = cube.withNormals(upwards).withTexture(new double[2 * cube.totalCorners()]);
        assertEquals(8, PackedFaces.shared(alike, faces).triangles().vertexCount());
        assertEquals(24, PackedFaces.apart(alike, faces).triangles().vertexCount());
    }

    @Test
    @DisplayName("some faces are drawn in the mesh's order, or with the triangles of others")
    void drawsSomeFacesInTheOrderAsked() {
        Mesh cube = Scenes.named("cube").mesh();
        PackedFaces packed = PackedFaces.apart(cube, new int[] {1, 3, 4});
        TriangleMesh drawn = packed.triangles(new int[] {4, 1});
        assertArrayEquals(new int[] {8, 9, 10, 8, 10, 11, 0, 1, 2, 0, 2, 3}, drawn.triangles());
    }

    /**
     * The mesh under one lamp, which lights backs as it does fronts, in stripes.
     *
     * @param first which of two colours face 0 has
     */
    private static Scene striped(Scene scene, int first) {
        LightModel lamp = LightModel.openGl(Light.from(LightSource.white(), 1, 2, 3));
        return new Scene(
                scene.name(),
                scene.mesh(),
                List.of(Appearance.dull(0xFF4020), Appearance.dull(0x20A0FF)),
                IntStream.range(0, scene.mesh().faceCount()).map(f -> (f + first) % 2).toArray(),
                new SceneLight(lamp, Optional.empty()),
                scene.backgroundRgb(),
                scene.defaultCamera(),
                scene.pictureScale());
    }

    private static RenderRequest request(Scene scene, ShadingMethod shading) {
        return new RenderRequest(
                scene,
                Renderer.PIPELINE,
                shading.code(),
                "perspective",
                scene.defaultCamera(),
                160,
                120);
    }
}
