package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.light.Material;
import rasterlab.engine.pipeline.paint.DepthCue;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.texture.Wrap;
import rasterlab.engine.transform.SphericalView;

class LookTest {
    /** Looks along −x; the world's y is to the right, z up. */
    private static final SphericalView LEVEL = new SphericalView(0, Math.PI / 2, 10);

    private static final int BACKGROUND = 0xFF203040;
    private static final int RED = 0;
    private static final int GLASS = 1;
    private static final int NET = 2;

    private final Renderer renderer = new Renderer();

    /** Squares that face the eye at x = 0, 1 and 2: red, half blue glass, a texture with holes. */
    private static Scene layers(int... faces) {
        var xyz = new double[36];
        for (int i = 0; i < 12; i++) {
            xyz[3 * i] = i / 4;
            xyz[3 * i + 1] = i % 4 == 0 || i % 4 == 3 ? -3 : 3;
            xyz[3 * i + 2] = i % 4 < 2 ? -3 : 3;
        }
        int[][] squares = {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}};
        double[] st = {0, 0, 1, 0, 1, 1, 0, 1};
        var all = new double[24];
        for (int i = 0; i < 24; i++) all[i] = st[i % 8];
        var net = Texture.of(2, 1, 4, new int[] {0x00FFFFFF, 0x8000FF00});
        var scene =
                new Scene(
                        "layers",
                        new Mesh(xyz, squares).withTexture(all),
                        List.of(
                                Appearance.of(color(1, 0, 0, 1)),
                                Appearance.of(color(0, 0, 1, 0.5)),
                                LitScenes.white().with(LitScenes.laid(net, Wrap.REPEAT))),
                        new int[] {RED, GLASS, NET},
                        LitScenes.everywhere(),
                        BACKGROUND & 0xFFFFFF,
                        LEVEL,
                        100);
        return scene.only(faces);
    }

    private static Material color(double r, double g, double b, double alpha) {
        double[] rgb = {r, g, b};
        double[] none = new double[3];
        return new Material(new SurfaceMaterial(rgb, none, none, none, 0), alpha);
    }

    private Raster draw(Scene scene, String shading, UnaryOperator<Look> change) {
        var plain = new RenderRequest(scene, "painter", shading, "perspective", LEVEL, 40, 30);
        return renderer.render(plain.with(change.apply(plain.look())), () -> false);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("transparent")
    void seesThroughFaces(int[] faces, String shading, int x, int argb) {
        UnaryOperator<Look> nearest = look -> look.withTexture(TextureMode.NEAREST);
        Raster picture = draw(layers(faces), shading, nearest);
        assertEquals(Integer.toHexString(argb), Integer.toHexString(picture.argb(x, 15)));
    }

    static Stream<Arguments> transparent() {
        return Stream.of(
                argumentSet("opaque face is mixed", new int[] {RED}, "flat", 15, 0xFFFF0000),
                argumentSet(
                        "glass hides what is behind",
                        new int[] {RED, GLASS},
                        "flat",
                        15,
                        0xFF7F0080),
                argumentSet(
                        "glass hides the background", new int[] {GLASS}, "phong", 15, 0xFF1018A0),
                argumentSet(
                        "Gouraud's glass is opaque",
                        new int[] {RED, GLASS},
                        "gouraud",
                        15,
                        0xFF7F0080),
                argumentSet("hole of a net hides", new int[] {RED, NET}, "flat", 15, 0xFFFF0000),
                argumentSet(
                        "thread of a net is opaque", new int[] {RED, NET}, "flat", 25, 0xFF7F8000));
    }

    @Test
    @DisplayName("a fully opaque texture makes a face transparent, or CLAMP's border does not")
    void borderIsSeenThrough() {
        Texture solid = Texture.of(1, 1, 4, new int[] {0xFF00FF00});
        for (Wrap wrap : Wrap.values()) {
            var laid =
                    new LaidTexture(solid, wrap, wrap, TextureEnvironment.of(Mode.REPLACE, solid));
            Scene scene = layers(RED, NET).with(f -> f.texture().isEmpty() ? f : f.with(laid));
            Raster picture = draw(scene, "flat", look -> look);
            boolean border = picture.argb(10, 15) != 0xFF00FF00;
            assertEquals(255, picture.argb(10, 15) >>> 24, wrap + ": is mixed with what is behind");
            assertEquals(wrap == Wrap.CLAMP, border, wrap + " " + picture.argb(10, 15));
        }
    }

    @Test
    @DisplayName("a pixel that a rounded polygon adds beyond an edge shows the texture's other end")
    void pixelsBeyondAnEdgeHaveTheColorOfTheEdge() {
        double[] xyz = {0, -3.5, -3.5, 0, 3.5, -3.5, 0, 3.5, 3.5, 0, -3.5, 3.5};
        double[] st = {0, 0, 0.9, 0, 0.9, 1, 0, 1};
        Texture halves = Texture.of(2, 1, 3, new int[] {0xFF0000, 0x0000FF});
        var scene =
                LitScenes.scene(
                        new Mesh(xyz, new int[][] {{0, 1, 2, 3}}).withTexture(st),
                        LitScenes.white().with(LitScenes.laid(halves, Wrap.REPEAT)),
                        LitScenes.everywhere());
        Raster picture =
                draw(
                        scene.zoomed(100 / 180.0),
                        "flat",
                        look ->
                                look.withVisibility("painter-textbook")
                                        .withTexture(TextureMode.NEAREST));
        assertEquals("ffff0000", Integer.toHexString(picture.argb(1, 15)));
        assertEquals("ff0000ff", Integer.toHexString(picture.argb(39, 15)));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("terms")
    void leavesTermsOut(Set<LightTerm> seen, int argb) {
        double[] all = {0.1, 0.2, 0.3};
        var material = new Material(new SurfaceMaterial(all, all, all, all, 0), 1);
        double[] one = {1, 1, 1};
        var light = new LightSource(new double[3], one, one, Attenuation.none(), SpotCone.none());
        var scene =
                LitScenes.scene(
                        layers(RED).mesh(),
                        Appearance.of(material),
                        new SceneLight(
                                new LightModel(one, false, false, Reflection.PHONG, List.of()),
                                Optional.of(light)));
        Raster picture = draw(scene, "flat", look -> look.withLight(seen, Sides.SCENE));
        assertEquals(Integer.toHexString(argb), Integer.toHexString(picture.argb(20, 15)));
    }

    static Stream<Arguments> terms() {
        return Stream.of(
                argumentSet("a term is lost", LightTerm.all(), 0xFF66CCFF),
                argumentSet("no term is all terms", Set.of(), 0xFF000000),
                argumentSet("ambient is left out", Set.of(LightTerm.AMBIENT), 0xFF1A334D),
                argumentSet(
                        "emission is left in",
                        Set.of(LightTerm.DIFFUSE, LightTerm.SPECULAR),
                        0xFF336699));
    }

    @Test
    @DisplayName("culling leaves out the other side, or draws a face with another's colour")
    void leavesSidesOut() {
        Scene ball = LitScenes.shinyBall(LitScenes.lamps(Reflection.PHONG, true, true));
        var above = new SphericalView(2.5, 0.5, 5);
        var plain = new RenderRequest(ball, "raycast", "phong", "perspective", above, 120, 90);
        int[] whole = renderer.render(plain, () -> false).argb();
        int[] outer =
                renderer.render(plain.with(plain.look().withCull(Cull.BACK)), () -> false).argb();
        int[] inner =
                renderer.render(plain.with(plain.look().withCull(Cull.FRONT)), () -> false).argb();
        int fewer = 0;
        int deeper = 0;
        for (int i = 0; i < whole.length; i++) {
            if (whole[i] != outer[i]) {
                fewer++;
                assertEquals(BACKGROUND, outer[i], "pixel " + i);
                assertEquals(whole[i], inner[i], "pixel " + i);
            }
            if (whole[i] != inner[i]) deeper++;
        }
        assertTrue(fewer > 300, fewer + " pixels show the inside");
        assertTrue(deeper > 300, deeper + " pixels show the outside");
    }

    @Test
    @DisplayName("what is nearest fades, what is farthest does not, or transparency is lost")
    void fadesLinearlyWithDepth() {
        UnaryOperator<Look> cue = look -> look.withCue(new DepthCue(0.75));
        assertEquals(0xFFFF0000, draw(layers(RED), "flat", look -> look).argb(20, 15));
        assertEquals(
                Integer.toHexString(0xFF582430),
                Integer.toHexString(draw(layers(RED), "flat", cue).argb(20, 15)),
                "at z = 10 of 8 to 10");
        assertEquals(
                Integer.toHexString(draw(layers(NET), "flat", look -> look).argb(25, 15)),
                Integer.toHexString(draw(layers(NET), "flat", cue).argb(25, 15)),
                "at z = 8 of 8 to 10");
    }

    @Test
    @DisplayName("what is cut off for its depth still counts for the depth cue")
    void fadesBetweenTheDepthsThatAreDrawn() {
        var plain =
                new RenderRequest(layers(GLASS), "painter", "flat", "perspective", LEVEL, 40, 30);
        var cued = plain.with(plain.look().withCue(new DepthCue(0.75)));
        int glass = cut(cued, 7, 9.5).argb(15, 15);
        assertEquals("ff182470", Integer.toHexString(glass), "half faded at 9 of 8 to 9.5");
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("shadings")
    void autoChooses(Scene scene, Set<LightTerm> terms, String chosen, String reason) {
        var plain = new RenderRequest(scene, "zfloat", "auto", "perspective", LEVEL, 40, 30);
        var request = plain.with(plain.look().withLight(terms, Sides.SCENE));
        assertEquals(new Choice(chosen, reason), Renderer.shading(request));
        assertEquals(
                List.of(
                        renderer.render(
                                        request.withShading(ShadingMethod.named(chosen)),
                                        () -> false)
                                .argb()[600]),
                List.of(renderer.render(request, () -> false).argb()[600]));
    }

    private static LightModel lambert(LightModel model) {
        return new LightModel(
                model.globalAmbient(),
                model.localViewer(),
                model.twoSided(),
                Reflection.LAMBERT,
                model.lights());
    }

    static Stream<Arguments> shadings() {
        var all = LightTerm.all();
        Scene shiny = LitScenes.shinyBall(LitScenes.lamps(Reflection.PHONG, true, true));
        Scene dull = LitScenes.shinyBall(LitScenes.lamps(Reflection.LAMBERT, true, true));
        Scene spot = LitScenes.shinyBall(lambert(LitScenes.spot()));
        return Stream.of(
                argumentSet(
                        "flat faces are smoothed",
                        layers(RED),
                        all,
                        "flat",
                        "corners have no normals of their own"),
                argumentSet(
                        "highlights are lost",
                        shiny,
                        all,
                        "phong",
                        "highlights would be lost between corners"),
                argumentSet(
                        "highlights that are left out cost time",
                        shiny,
                        Set.of(LightTerm.DIFFUSE),
                        "gouraud",
                        "no highlights and no spot lights"),
                argumentSet(
                        "dull surface is shaded per pixel",
                        dull,
                        all,
                        "gouraud",
                        "no highlights and no spot lights"),
                argumentSet(
                        "rim of a spot light is lost",
                        spot,
                        all,
                        "phong",
                        "a spot light's rim would be lost between corners"));
    }

    @Test
    @DisplayName("depths are not cut, or the wrong ones are")
    void cutsDepths() {
        var plain =
                new RenderRequest(
                        layers(RED, NET), "painter", "flat", "perspective", LEVEL, 40, 30);
        assertEquals(0xFFFF0000, cut(plain, 8.5, 20).argb(25, 15), "without the net before it");
        assertNotEquals(0xFFFF0000, cut(plain, 7.5, 20).argb(25, 15));
        assertEquals(BACKGROUND, cut(plain, 8.5, 9.5).argb(25, 15), "with neither");
    }

    private Raster cut(RenderRequest plain, double near, double far) {
        return renderer.render(
                new RenderRequest(
                        plain.scene(),
                        plain.camera(),
                        plain.projection(),
                        new DrawnDepths(near, far),
                        40,
                        30,
                        plain.look()),
                () -> false);
    }
}
