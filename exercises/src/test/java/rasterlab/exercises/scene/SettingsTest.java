package rasterlab.exercises.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.Cull;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.Stereo;
import rasterlab.engine.pipeline.paint.DepthCue;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.texture.Wrap;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.ClipPlane;

class SettingsTest {
    /** Everything, and nothing as it usually is. */
    private static final Settings ALL =
            Settings.NONE
                    .with(SceneSetting.CAMERA, new SphericalView(0.1, 1 / 3.0, 450))
                    .with(SceneSetting.PROJECTION, Projection.PERSPECTIVE)
                    .with(SceneSetting.ZOOM, 1 / 3.0)
                    .with(SceneSetting.NEAR, 100.1)
                    .with(SceneSetting.FAR, 700.7)
                    .with(
                            SceneSetting.CLIP_PLANES,
                            List.of(new ClipPlane(1, 0, -0.1, 1e-9), new ClipPlane(0, 1, 0, 33)))
                    .with(SceneSetting.VISIBILITY, "painter")
                    .with(SceneSetting.SHADING, ShadingMethod.GOURAUD)
                    .with(SceneSetting.TEXTURE, TextureMode.LINEAR)
                    .with(SceneSetting.TEXTURE_IMAGE, "wood.png")
                    .with(SceneSetting.WRAP, Wrap.CLAMP_TO_EDGE)
                    .with(SceneSetting.ENVIRONMENT, Mode.BLEND)
                    .with(SceneSetting.TERMS, Set.of(LightTerm.DIFFUSE, LightTerm.SPECULAR))
                    .with(SceneSetting.TWO_SIDED, false)
                    .with(SceneSetting.CULL, Cull.BACK)
                    .with(SceneSetting.HIDDEN_LINES, HiddenLines.DASHED)
                    .with(SceneSetting.CREASE, 12.5)
                    .with(SceneSetting.OUTLINE, true)
                    .with(SceneSetting.DEPTH_CUE, new DepthCue(0.7))
                    .with(SceneSetting.STEREO, Stereo.StereoMode.SIDE_BY_SIDE)
                    .with(SceneSetting.EYES, 12.34);

    @Test
    @DisplayName("a setting is lost on its way through a file, or is not tried here")
    void everySettingRoundTrips() {
        for (SceneSetting<?> setting : all())
            assertTrue(ALL.get(setting).isPresent(), setting + " is not tried");
        assertEquals(ALL, readBack(ALL));
        assertEquals(Settings.NONE, readBack(Settings.NONE));
    }

    @ParameterizedTest(name = "{0} alone is lost, or brings another setting with it")
    @MethodSource("all")
    <T> void oneSettingRoundTrips(SceneSetting<T> setting) {
        Settings one = Settings.NONE.with(setting, ALL.get(setting).orElseThrow());
        assertEquals(one, readBack(one));
        Map<Boolean, Long> found =
                all().stream()
                        .collect(
                                Collectors.partitioningBy(
                                        each -> readBack(one).get(each).isPresent(),
                                        Collectors.counting()));
        assertEquals(1, found.get(true));
    }

    static List<SceneSetting<?>> all() {
        return Stream.concat(SceneSetting.OF_VIEW.stream(), SceneSetting.OF_LOOK.stream()).toList();
    }

    private static Settings readBack(Settings settings) {
        var source = new SceneSource.ByName("vase", OptionalInt.empty());
        String json = new SceneView(source, settings).write();
        return ((SceneView) SceneFile.read(json)).settings();
    }

    @ParameterizedTest(name = "{0} is read")
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "`zoom`: 0 | $.zoom: must be a number from 1.0E-6 to 1000000.0, got 0",
                "`near`: `1` | $.near: must be a number from -1.0E30 to 1.0E30, got \"1\"",
                "`near`: 5, `far`: 5 | $.far: must be above near, 5.0, got 5.0",
                "`clipPlanes`: [1, 0, 0, 0] | $.clipPlanes[0]: must be an array […], got 1",
                "`clipPlanes`: [[1, 0, 0]] | $.clipPlanes[0]: must have 4 numbers, got 3",
                "`clipPlanes`: [[0, 0, 0, 1]] | $.clipPlanes[0]: a clip plane needs a direction: a,"
                        + " b or c other than 0",
                "`look`: {`wrap`: `tile`} | $.look.wrap: no wrap 'tile'; there are repeat,"
                        + " mirrored, clamp-to-edge, clamp",
                "`look`: {`environment`: 1} | $.look.environment: must be a text that is not blank,"
                        + " got 1",
                "`look`: {`textureImage`: ``} | $.look.textureImage: must be a text that is not"
                        + " blank, got \"\"",
                "`look`: {`terms`: `all`} | $.look.terms: must be an array […], got \"all\"",
                "`look`: {`terms`: [`glow`]} | $.look.terms[0]: no light term 'glow'; there are"
                        + " ambient, diffuse, specular, emission",
                "`look`: {`terms`: [`diffuse`, `diffuse`]} | $.look.terms[1]: names 'diffuse' twice",
                "`look`: {`twoSided`: `yes`} | $.look.twoSided: must be true or false, got \"yes\"",
                "`look`: {`cull`: `left`} | $.look.cull: no cull 'left'; there are none, back, front",
                "`look`: {`hiddenLines`: `gone`} | $.look.hiddenLines: no hiddenLines 'gone'; there"
                        + " are removed, dashed, shown",
                "`look`: {`crease`: 181} | $.look.crease: must be a number from 0.0 to 180.0, got 181",
                "`look`: {`outline`: 1} | $.look.outline: must be true or false, got 1",
                "`look`: {`depthCue`: 0} | $.look.depthCue: depth cue must be above 0, up to 1, got"
                        + " 0.0",
                "`look`: {`stereo`: `red`} | $.look.stereo: no stereo 'red'; there are anaglyph,"
                        + " side-by-side",
                "`look`: {`eyes`: 0} | $.look.eyes: must be a number from 1.0E-6 to 1000000.0, got 0",
                "`look`: {`zoom`: 1} | $.look.zoom: is not known here; known are visibility,"
                        + " shading, texture, textureImage, wrap, environment, terms, twoSided, cull,"
                        + " hiddenLines, crease, outline, depthCue, stereo, eyes",
                "`cull`: `back` | $.cull: is not known here; known are version, scene, detail,"
                        + " camera, projection, zoom, near, far, clipPlanes, look",
            })
    void refusesWithThePath(String said, String message) {
        String json = "{`version`: 1, `scene`: `vase`, %s}".formatted(said).replace('`', '"');
        var refusal = assertThrows(IllegalArgumentException.class, () -> SceneFile.read(json));
        assertEquals(message, refusal.getMessage());
    }

    @Test
    @DisplayName("a value that no file may have is written")
    void refusesWhatCouldNotBeRead() {
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> Settings.NONE.with(SceneSetting.ZOOM, 1e7));
        assertEquals(
                "$.zoom: must be a number from 1.0E-6 to 1000000.0, got 1.0E7",
                refusal.getMessage());
    }
}
