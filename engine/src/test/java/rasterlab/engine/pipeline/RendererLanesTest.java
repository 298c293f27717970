package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;

/** The pipeline's pictures of all scenes in eight lanes beside those in one. */
@Tag("slow")
class RendererLanesTest {
    static Stream<String> scenes() {
        return Scenes.all().stream().map(Scene::name);
    }

    @ParameterizedTest(name = "{0} is another picture in eight lanes")
    @MethodSource("scenes")
    void isTheSamePicture(String name) {
        EightLanes.assumeThere();
        Scene scene = Scenes.named(name);
        var one = new Renderer(() -> new TrianglePipeline(1, Lanes.ONE));
        try {
            for (int threads = 1; threads <= 3; threads++)
                for (String shading : List.of("flat", "gouraud", "phong")) {
                    var request =
                            new RenderRequest(
                                    scene,
                                    Renderer.PIPELINE,
                                    shading,
                                    "perspective",
                                    scene.defaultCamera(),
                                    240,
                                    180);
                    assertArrayEquals(
                            one.render(request, () -> false).argb(),
                            eight(threads, request),
                            "%s with %d threads".formatted(shading, threads));
                }
        } finally {
            one.close();
        }
    }

    private static int[] eight(int threads, RenderRequest request) {
        var renderer = new Renderer(() -> new TrianglePipeline(threads, Lanes.EIGHT));
        try {
            return renderer.render(request, () -> false).argb();
        } finally {
            renderer.close();
        }
    }
}
