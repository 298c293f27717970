package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.cli.Lab;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.visibility.scene.HazardView;
import rasterlab.app.visibility.scene.SavedScene;
import rasterlab.app.visibility.scene.SceneFiles;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.app.visibility.scene.TopicView;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.Cull;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.Stereo;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.texture.Wrap;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;

@Tag("slow")
@Timeout(300)
class VisibilityCommandTest {
    @TempDir Path folder;

    static Stream<Arguments> mistakes() {
        return Stream.of(
                mistake("zoom is lost", choice -> choice.zoomed(12)),
                mistake("small zoom is lost", choice -> choice.zoomed(0.3)),
                mistake("edges are lost", choice -> choice.withEdges(true)),
                mistake(
                        "edges are asked of a method without",
                        choice -> choice.withEdges(true).withVisibility("zfloat")),
                mistake("hazard's view is lost", HazardView.MEAN::shown),
                mistake("wires are drawn otherwise", VisibilityCommandTest::wires),
                mistake(
                        "near and far are lost",
                        choice -> choice.with(choice.look().withNear(0.9).withFar(1.05))),
                mistake(
                        "wires are asked for light and textures",
                        choice -> lit(textured(choice)).withShading("wire")),
                mistake("tones are asked for light", choice -> lit(choice).withShading("tone")),
                mistake("textures lie otherwise", VisibilityCommandTest::textured),
                mistake(
                        "light is lost",
                        choice ->
                                choice.withScene("sphere")
                                        .withShading("phong")
                                        .withVisibility("zfloat")
                                        .with(choice.look().withTerms(Set.of(LightTerm.SPECULAR)))),
                mistake(
                        "backs are lit otherwise",
                        choice ->
                                HazardView.OPENING
                                        .shown(choice)
                                        .withShading("flat")
                                        .with(choice.look().withSides(Sides.ONE))),
                mistake("depth cue is lost", choice -> choice.with(choice.look().withCue(0.55))),
                mistake(
                        "culling is lost",
                        choice -> choice.with(choice.look().withCull(Cull.FRONT))),
                mistake(
                        "an eye is lost",
                        choice ->
                                choice.with(
                                        choice.look()
                                                .withStereo(
                                                        Optional.of(Stereo.StereoMode.SIDE_BY_SIDE))
                                                .withEyes(0.1))),
                mistake(
                        "eyes are asked of a parallel projection",
                        choice ->
                                choice.withProjection("isometric")
                                        .with(
                                                choice.look()
                                                        .withStereo(
                                                                Optional.of(
                                                                        Stereo.StereoMode
                                                                                .ANAGLYPH)))));
    }

    private static VisibilityChoice wires(VisibilityChoice choice) {
        return choice.withScene("cube")
                .withShading("wire")
                .withVisibility("zfloat")
                .withEdges(true)
                .with(choice.look().withHidden(HiddenLines.DASHED).withCrease(20));
    }

    private static VisibilityChoice lit(VisibilityChoice choice) {
        return choice.with(
                choice.look().withTerms(Set.of(LightTerm.SPECULAR)).withSides(Sides.ONE));
    }

    private static VisibilityChoice textured(VisibilityChoice choice) {
        return choice.withScene("globe")
                .withShading("flat")
                .withVisibility("zfloat")
                .with(
                        choice.look()
                                .withTexture(TextureMode.NEAREST)
                                .withWrap(Optional.of(Wrap.CLAMP))
                                .withEnvironment(Optional.of(Mode.REPLACE)));
    }

    @Test
    void comparisonHasACommandForEachPicture() {
        try (var model =
                new VisibilityLabModel(
                        new OwnMethods(),
                        new Renderer()::render,
                        Runnable::run,
                        Throwable::printStackTrace)) {
            model.choose(
                    choice -> choice.comparing("cube", "painter", "warnock").withDifference(true));
            List<String> lines = VisibilityCommand.now(model).text().lines().toList();
            assertEquals(2, lines.size());
            assertTrue(lines.get(0).contains("--visibility painter"), lines.get(0));
            assertTrue(lines.get(1).contains("--visibility warnock"), lines.get(1));
        }
    }

    @Test
    void sceneThatIsInNoFileIsDrawnFromTheFileItIsSavedIn() throws Exception {
        var thread = new ModelThread();
        var failures = new CopyOnWriteArrayList<Throwable>();
        try (var model =
                new VisibilityLabModel(
                        new OwnMethods(), new Renderer()::render, thread, failures::add)) {
            model.resize(211, 97);
            assertFalse(VisibilityCommand.needsFile(model));
            var body = new VisibleFacesTopic().hazards().get(0).input();
            model.choose(TopicView.of("visible-faces-cube", body, "back-face", "back-face")::shown);
            assertTrue(VisibilityCommand.needsFile(model));
            model.keep(SceneFiles.save(folder.resolve("a.scene.json"), model.state().choice()));
            model.choose(choice -> choice.withVisibility("z32"));
            model.turn(0.3, 0.1);
            thread.settle(model::settle);
            assertFalse(VisibilityCommand.needsFile(model));
            assertDrawsTheSame(model);
            model.choose(choice -> choice.withView(StageView.GROWTH));
            assertFalse(VisibilityCommand.needsFile(model));
            assertEquals(List.of(), failures);
        }
    }

    @Test
    void anotherSceneIsNotDrawnFromTheFileOfTheLast() {
        try (var model =
                new VisibilityLabModel(
                        new OwnMethods(),
                        new Renderer()::render,
                        Runnable::run,
                        Throwable::printStackTrace)) {
            var bodies = new VisibleFacesTopic().hazards();
            model.choose(TopicView.of("a", bodies.get(0).input(), "back-face", "back-face")::shown);
            model.keep(new SavedScene(folder.resolve("a.json"), model.state().choice().shown()));
            assertFalse(VisibilityCommand.needsFile(model));
            model.choose(TopicView.of("b", bodies.get(3).input(), "back-face", "back-face")::shown);
            assertTrue(VisibilityCommand.needsFile(model));
        }
    }

    private static Arguments mistake(String name, UnaryOperator<VisibilityChoice> change) {
        return argumentSet(name, change);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void copiedCommandDrawsTheSamePicture(UnaryOperator<VisibilityChoice> change) throws Exception {
        var thread = new ModelThread();
        var failures = new CopyOnWriteArrayList<Throwable>();
        try (var model =
                new VisibilityLabModel(
                        new OwnMethods(), new Renderer()::render, thread, failures::add)) {
            model.resize(211, 97);
            model.choose(change);
            thread.settle(model::settle);
            assertEquals(List.of(), failures);
            assertDrawsTheSame(model);
        }
    }

    private void assertDrawsTheSame(VisibilityLabModel model) throws Exception {
        BufferedImage drawn = drawn(VisibilityCommand.now(model).text());
        assertArrayEquals(
                model.state().picture().orElseThrow().raster().argb(),
                drawn.getRGB(0, 0, drawn.getWidth(), drawn.getHeight(), null, 0, 211));
    }

    /** The picture that the command writes, into a folder of the test's own. */
    private BufferedImage drawn(String command) throws Exception {
        var words = new ArrayList<>(Arrays.asList(command.split(" ")));
        assertEquals("./lab", words.remove(0));
        Path file = folder.resolve(words.remove(words.size() - 1));
        words.add(file.toString());
        var nowhere = new PrintStream(OutputStream.nullOutputStream());
        int code =
                Lab.run(
                        words.toArray(String[]::new),
                        new ByteArrayInputStream(new byte[0]),
                        nowhere,
                        nowhere);
        assertEquals(0, code, command);
        return ImageIO.read(file.toFile());
    }
}
