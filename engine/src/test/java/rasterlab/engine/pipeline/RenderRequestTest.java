package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.pipeline.paint.DepthCue;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.pipeline.wire.WireStyle;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;

class RenderRequestTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(
            String visibility,
            String shading,
            String projection,
            int width,
            boolean outline,
            String message) {
        Scene vase = Scenes.named("vase");
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> {
                            var request =
                                    new RenderRequest(
                                            vase,
                                            visibility,
                                            shading,
                                            projection,
                                            vase.defaultCamera(),
                                            width,
                                            10);
                            if (outline) request.withOutline();
                        });
        assertEquals(message, refusal.getMessage());
    }

    static Stream<Arguments> mistakes() {
        String z = "zfloat";
        String central = "perspective";
        return Stream.of(
                argumentSet(
                        "unknown visibility is accepted",
                        "z17",
                        "tone",
                        central,
                        10,
                        false,
                        "no visibility method 'z17'; there are "
                                + String.join(", ", Renderer.visibilities())
                                + ", raycast-surface; did you mean 'z16'?"),
                argumentSet(
                        "unknown shading is accepted",
                        z,
                        "Tone",
                        central,
                        10,
                        false,
                        "no shading 'Tone'; there are tone, wire, flat, gouraud, phong, auto; did you"
                                + " mean 'tone'?"),
                argumentSet(
                        "unknown projection is accepted",
                        z,
                        "tone",
                        "",
                        10,
                        false,
                        "no projection ''; there are " + String.join(", ", Renderer.projections())),
                argumentSet(
                        "no pixel is accepted",
                        z,
                        "tone",
                        central,
                        0,
                        false,
                        "picture size must be from 1×1 to 8192×8192 pixels, got 0×10"),
                argumentSet(
                        "outline is silently dropped by zfloat",
                        z,
                        "tone",
                        central,
                        10,
                        true,
                        "visibility 'zfloat' draws no outlines; those that do are"
                                + " none, back-face, convex, painter-textbook, painter"),
                argumentSet(
                        "outline is silently dropped by raycast",
                        "raycast",
                        "tone",
                        central,
                        10,
                        true,
                        "visibility 'raycast' draws no outlines; those that do are"
                                + " none, back-face, convex, painter-textbook, painter"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("looks")
    void refusesLooks(UnaryOperator<RenderRequest> change, String message) {
        Scene vase = Scenes.named("vase");
        var camera = new SphericalView(1, 1, 500);
        var plain = new RenderRequest(vase, "zfloat", "flat", "perspective", camera, 9, 7);
        var refusal = assertThrows(IllegalArgumentException.class, () -> change.apply(plain));
        assertEquals(message, refusal.getMessage());
    }

    static Stream<Arguments> looks() {
        return Stream.of(
                look(
                        "far before near is accepted",
                        r -> depths(r, Projection.PERSPECTIVE, 9, 3),
                        "near must be below far, got near 9.0, far 3.0"),
                look(
                        "near plane in the eye is accepted",
                        r -> depths(r, Projection.PERSPECTIVE, 0, 3),
                        "near must be above 0 in perspective, at least 5.0E-4 for an eye at 500.0,"
                                + " got 0.0"),
                look(
                        "near that is no number is accepted",
                        r -> depths(r, Projection.PARALLEL, Double.NaN, 3),
                        "near must be a number below far, 3.0, got NaN"),
                look(
                        "far that is no number is accepted",
                        r -> depths(r, Projection.PARALLEL, 3, Double.NaN),
                        "far must be a number above near, 3.0, got NaN"),
                look(
                        "two eyes see a parallel picture",
                        r ->
                                depths(
                                        r.with(r.look().withStereo(ANAGLYPH)),
                                        Projection.ISOMETRIC,
                                        0,
                                        3),
                        "stereo needs perspective, since two eyes see the same in projection"
                                + " 'isometric'"),
                look(
                        "eyes a negative distance apart are accepted",
                        r -> r.with(r.look().withStereo(new Stereo(ANAGLYPH.kind(), -1))),
                        "eyes' separation must be finite and not negative, got -1.0"),
                look(
                        "eyes half a turn apart are accepted",
                        r -> {
                            Stereo.separationAt(180, 5);
                            return r;
                        },
                        "angle between the eyes must be above 0, below 180 degrees, got 180.0"),
                look(
                        "depth cue above 1 is accepted",
                        r -> r.with(r.look().withCue(new DepthCue(1.5))),
                        "depth cue must be above 0, up to 1, got 1.5"),
                look(
                        "crease beyond a half turn is accepted",
                        r -> r.with(r.look().withWire(new WireStyle(HiddenLines.SHOWN, 181))),
                        "crease must be from 0 to 180 degrees, got 181.0"));
    }

    private static final Stereo ANAGLYPH = new Stereo(Stereo.StereoMode.ANAGLYPH, 1);

    private static Arguments look(
            String mistake, UnaryOperator<RenderRequest> change, String message) {
        return argumentSet(mistake, change, message);
    }

    private static RenderRequest depths(
            RenderRequest plain, Projection projection, double near, double far) {
        return new RenderRequest(
                plain.scene(),
                plain.camera(),
                projection,
                new DrawnDepths(near, far),
                9,
                7,
                plain.look());
    }
}
