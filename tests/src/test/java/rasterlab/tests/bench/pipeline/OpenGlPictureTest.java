package rasterlab.tests.bench.pipeline;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.opengl.context.NoOpenGl;
import rasterlab.app.opengl.context.OffscreenContext;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.Raster;
import rasterlab.tests.bench.language.BenchWords;

/** A user's pictures beside OpenGL's; skipped where there is no OpenGL. */
@Tag("slow")
class OpenGlPictureTest {
    /** The share of pixels that may be off by more than 2 levels. */
    private static final double BOUND = 1e-4;

    private static OffscreenContext context;
    private static String missing = "";

    @BeforeAll
    static void open() {
        try {
            context = OffscreenContext.open(OffscreenContext.ContextProfile.CORE);
        } catch (NoOpenGl e) {
            missing = e.getMessage();
        }
    }

    @AfterAll
    static void close() {
        if (context != null) context.close();
    }

    @ParameterizedTest(name = "{0} looks otherwise than in OpenGL")
    @EnumSource(TorusLook.class)
    void pixelsAreThoseOfOpenGl(TorusLook look) {
        assumeTrue(context != null, missing);
        var scene = new TorusScene(20_000, 960, 540);
        var out = new Raster(scene.width(), scene.height());
        try (var renderer = new Renderer();
                var torus = new GlTorus(scene, look)) {
            renderer.render(scene.request(look), out, () -> false);
            torus.draw();
            var difference = Difference.of(out.argb(), torus.read());
            assertTrue(
                    difference.off() <= BOUND * difference.pixels(),
                    difference.text(BenchWords.ENGLISH));
        }
    }
}
