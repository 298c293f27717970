package rasterlab.app.opengl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.opengl.context.NoOpenGl;
import rasterlab.app.opengl.software.Deviations;
import rasterlab.app.opengl.software.SoftwarePainter;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.GlFrame;
import rasterlab.app.opengl.state.Group;
import rasterlab.app.opengl.state.LabImages;
import rasterlab.app.opengl.state.Setting;

/** Every state in both halves; skipped where OpenGL cannot draw without a window. */
@Tag("slow")
class StatesTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;

    /** The share of pixels that may be off by more than 2 levels. */
    private static final double BOUND = 1e-4;

    /** The bound for what is named and yet nearly the same: edges and levels of smooth pictures. */
    private static final double NAMED_BOUND = 1e-3;

    private static OffscreenGl openGl;
    private static SoftwarePainter software;
    private static LabImages images;
    private static String missing = "";

    @BeforeAll
    static void open() {
        openGl = new OffscreenGl();
        software = new SoftwarePainter();
        images = new LabImages();
        try {
            openGl.draw(new GlFrame(GlChoice.first(), 1, 1, images.of(GlChoice.first())));
        } catch (NoOpenGl e) {
            missing = e.getMessage();
        }
    }

    @AfterAll
    static void close() {
        openGl.close();
        software.close();
    }

    static Stream<String> states() {
        var states = new ArrayList<String>();
        for (Setting setting : Setting.values()) {
            if (setting == Setting.SCENE) continue;
            for (String scene : scenes(setting))
                for (String option : setting.options())
                    if (!option.equals("file"))
                        states.add("SCENE=%s %s=%s".formatted(scene, setting.name(), option));
        }
        for (String components : Setting.COMPONENTS.options())
            for (String mode : Setting.ENV_MODE.options())
                states.add(
                        "SCENE=quad COMPONENTS=%s ENV_MODE=%s BLEND=%s"
                                .formatted(components, mode, Setting.BLEND.options().get(1)));
        for (String lighting : Setting.LIGHTING.options())
            for (String shading : Setting.SHADE_MODEL.options())
                states.add(
                        "SCENE=sphere LIGHTING=%s SHADE_MODEL=%s LIGHTS=2 ALPHA=0.5 BLEND=%s"
                                .formatted(lighting, shading, Setting.BLEND.options().get(1)));
        states.add("SCENE=quad ALPHA_TEST=GL_GEQUAL COMPONENTS=4 IMAGE=checker");
        states.add("SCENE=sphere LIGHT_PLACE=inside SPOT=30:16 ATTENUATION=0.5:0:0.5");
        return states.stream();
    }

    private static List<String> scenes(Setting setting) {
        return setting.group() == Group.TEXTURE
                ? List.of("quad", "globe")
                : List.of("sphere", "globe");
    }

    private static GlChoice choice(String state) {
        GlChoice choice = GlChoice.first();
        for (String each : state.split(" ")) {
            String[] parts = each.split("=");
            choice = choice.with(Setting.valueOf(parts[0]), parts[1]);
        }
        return choice;
    }

    private static Comparison compared(GlChoice choice) {
        return compared(choice, WIDTH, HEIGHT);
    }

    private static Comparison compared(GlChoice choice, int width, int height) {
        assumeTrue(missing.isEmpty(), missing);
        var frame = new GlFrame(choice, width, height, images.of(choice));
        return Comparison.of(openGl.draw(frame).picture(), software.draw(frame, () -> false));
    }

    @ParameterizedTest(name = "the halves differ and nobody says why: {0}")
    @MethodSource("states")
    void bothHalvesShowTheSameState(String state) {
        GlChoice choice = choice(state);
        Comparison found = compared(choice);
        boolean named = !Deviations.of(choice).isEmpty();
        assertTrue(
                named || found.share() <= BOUND,
                "%s: %d pixels are off, by up to %d levels"
                        .formatted(
                                state,
                                found.plain().wrongPixels(),
                                found.plain().largestLevelDifference()));
    }

    /** Small pictures, as in a small window, where the ends of lines are many. */
    @ParameterizedTest(name = "ends of lines differ in a small picture: {0}×{1}")
    @CsvSource({"289, 200", "385, 192", "294, 252", "276, 157", "250, 162", "442, 291"})
    void bothHalvesAgreeAtEverySize(int width, int height) {
        Comparison found = compared(GlChoice.first(), width, height);
        assertTrue(found.share() <= BOUND, found.plain().wrongPixels() + " pixels are off");
    }

    /** The sphere's equator lies, seen from the side, exactly between the two middle rows. */
    @ParameterizedTest(name = "a line between two rows is in another one: {0}×{1}, turned by {2}°")
    @CsvSource({"298, 182, 58", "298, 182, 0", "640, 480, 58", "301, 200, 33", "640, 481, 58"})
    void bothHalvesAgreeWhereALineIsBetweenTwoRows(int width, int height, double turn) {
        GlChoice first = GlChoice.first();
        GlChoice aside = first.turned(turn - first.turn(), -first.tilt());
        assertEquals(0, aside.tilt());
        Comparison found = compared(aside, width, height);
        assertTrue(found.share() <= BOUND, found.plain().wrongPixels() + " pixels are off");
    }

    @ParameterizedTest(name = "{0} is named and both halves have it")
    @EnumSource(
            value = Deviations.class,
            names = {"DEPTH_FUNC", "ALPHA_LESS", "BLEND_FUNC", "AFFINE"})
    void whatOneHalfLacksIsSeen(Deviations deviation) {
        String state =
                switch (deviation) {
                    case DEPTH_FUNC -> "SCENE=sphere DEPTH_FUNC=GL_GREATER";
                    case ALPHA_LESS -> "SCENE=sphere ALPHA_TEST=GL_LESS";
                    case BLEND_FUNC -> "SCENE=globe TEXTURE_2D=off BLEND=GL_SRC_ALPHA:GL_ONE";
                    default -> "SCENE=quad INTERPOLATION=affine";
                };
        assertEquals(List.of(deviation), Deviations.of(choice(state)));
        assertTrue(compared(choice(state)).share() > NAMED_BOUND, state);
    }

    static Stream<String> nearlyTheSame() {
        return Stream.of(
                "SCENE=sphere NEAR_FAR=0.001:100000",
                "SCENE=sphere POLYGON_MODE=GL_LINE",
                "SCENE=globe POLYGON_MODE=GL_LINE",
                "SCENE=globe IMAGE=waves MIN_FILTER=GL_LINEAR_MIPMAP_LINEAR",
                "SCENE=quad IMAGE=waves MIN_FILTER=GL_LINEAR_MIPMAP_LINEAR",
                "SCENE=quad IMAGE=waves MIN_FILTER=GL_LINEAR_MIPMAP_NEAREST",
                "SCENE=sphere SHADE_MODEL=GL_FLAT",
                "SCENE=sphere LIGHTS=2 ALPHA=0.5 BLEND=GL_SRC_ALPHA:GL_ONE_MINUS_SRC_ALPHA",
                "SCENE=sphere SHADE_MODEL=GL_FLAT LIGHTING=color ALPHA=0.5"
                        + " BLEND=GL_SRC_ALPHA:GL_ONE_MINUS_SRC_ALPHA");
    }

    @ParameterizedTest(name = "a name hides a mistake: {0}")
    @MethodSource("nearlyTheSame")
    void namedDifferencesAreSmall(String state) {
        assertTrue(!Deviations.of(choice(state)).isEmpty(), "nobody names it");
        Comparison found = compared(choice(state));
        assertTrue(
                found.share() <= NAMED_BOUND,
                state + ": " + found.plain().wrongPixels() + " pixels are off");
    }

    @ParameterizedTest(name = "the setting {0} changes nothing in either half")
    @EnumSource(
            value = Setting.class,
            mode = EnumSource.Mode.EXCLUDE,
            names = {"SCENE", "DISPLAY_LIST", "INTERPOLATION", "MAG_FILTER"})
    void everySettingIsSeen(Setting setting) {
        assumeTrue(missing.isEmpty(), missing);
        GlChoice seen = choice(whereSeen(setting));
        var plain = new GlFrame(seen, WIDTH, HEIGHT, images.of(seen));
        int[] before = openGl.draw(plain).picture().argb();
        boolean changes = false;
        for (String option : setting.options()) {
            if (option.equals("file")) continue;
            GlChoice other = seen.with(setting, option);
            var frame = new GlFrame(other, WIDTH, HEIGHT, images.of(other));
            changes |= !java.util.Arrays.equals(before, openGl.draw(frame).picture().argb());
        }
        assertTrue(changes, setting.code());
    }

    /** A choice in which the setting matters. */
    private static String whereSeen(Setting setting) {
        return switch (setting) {
            case ALPHA, DEPTH_MASK ->
                    "SCENE=sphere ALPHA=0.5 BLEND=GL_SRC_ALPHA:GL_ONE_MINUS_SRC_ALPHA";
            case NEAR_FAR -> "SCENE=globe PROJECTION=ortho TEXTURE_2D=off";
            case WRAP_S, WRAP_T, COORDINATES, SIZE, COMPONENTS, MIN_FILTER ->
                    "SCENE=quad TEXTURE_MATRIX=scale";
            case IMAGE, ENV_MODE, TEXTURE_MATRIX -> "SCENE=globe";
            default -> "SCENE=sphere";
        };
    }
}
