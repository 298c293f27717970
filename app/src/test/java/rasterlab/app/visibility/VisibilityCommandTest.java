package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Lab;
import rasterlab.engine.pipeline.Renderer;

@Timeout(60)
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
                mistake("hazard's view is lost", HazardView.MEAN::shown));
    }

    private static Arguments mistake(String name, UnaryOperator<VisibilityChoice> change) {
        return argumentSet(name, change);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void copiedCommandDrawsTheSamePicture(UnaryOperator<VisibilityChoice> change) throws Exception {
        var events = new ConcurrentLinkedQueue<Runnable>();
        var failures = new CopyOnWriteArrayList<Throwable>();
        try (var model =
                new VisibilityLabModel(new Renderer()::render, events::add, failures::add)) {
            model.resize(211, 97);
            model.choose(change);
            model.settle();
            for (Runnable event = events.poll(); event != null; event = events.poll()) event.run();
            assertEquals(List.of(), failures);
            BufferedImage drawn = drawn(VisibilityCommand.of(model));
            assertArrayEquals(
                    model.state().picture().orElseThrow().raster().argb(),
                    drawn.getRGB(0, 0, drawn.getWidth(), drawn.getHeight(), null, 0, 211));
        }
    }

    /** What the command writes, into a folder of the test's own. */
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
