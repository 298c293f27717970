package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** The user's own program draws the scenes of the lab of hidden surfaces. */
@Tag("slow")
@Timeout(300)
class OwnSceneTest {
    private static final String ALL_VISIBLE =
            """
            import rasterlab.contract.*;
            public class Mine implements VisibleFaces {
                public boolean[] visible(double[] xyz, int[][] faces, double[] eye, double[] inside) {
                    boolean[] all = new boolean[faces.length];
                    java.util.Arrays.fill(all, true);
                    return all;
                }
            }
            """;

    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final OwnMethods own = new OwnMethods();
    private final VisibilityLabModel model =
            new VisibilityLabModel(own, PictureMaker.by(new Renderer()), thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        own.close();
        assertEquals(List.of(), failures);
    }

    private void show(String id, String source, String scene) {
        Exercise exercise = Catalogue.builtIn().named(id);
        own.bring(exercise, source.isEmpty() ? exercise.evidence().model().orElseThrow() : source);
        model.enterOwn(exercise.topic());
        model.choose(choice -> choice.withScene(scene).withVisibility(OwnMethods.NAME));
        settle();
    }

    private void settle() {
        model.resize(160, 120);
        thread.settle(model::settle);
    }

    private Picture picture() {
        return model.state().picture().orElseThrow();
    }

    private int wrong() {
        return (int) model.state().difference().orElseThrow().wrongPixels();
    }

    @Test
    void rightFacesOfAConvexBodyAreItsPicture() {
        show("visible-faces", "", "cube");
        assertEquals(Optional.empty(), picture().refusal());
        assertFalse(picture().isEmpty());
        assertEquals(0, wrong());
    }

    @ParameterizedTest
    @ValueSource(strings = {"vase", "cyclic-overlap"})
    void aRightOrderIsThePictureOfAnyScene(String scene) {
        show("depth-order", "", scene);
        assertEquals(Optional.empty(), picture().refusal());
        assertEquals(0, wrong());
    }

    @Test
    void wrongFacesAreMarkedAfterEachTurn() {
        show("visible-faces", ALL_VISIBLE, "cube");
        int before = wrong();
        model.turn(1, 0.3);
        model.count();
        settle();
        assertTrue(before > 0 && wrong() > 0, before + ", then " + wrong());
    }

    @Test
    void itsStepsAreTheFacesThatItCallsVisible() {
        show("visible-faces", "", "cube");
        model.watchSteps(true);
        settle();
        assertEquals(3, model.lastStep());
        model.goTo(1);
        settle();
        assertFalse(picture().isEmpty());
        assertEquals(OwnMethods.NAME, picture().request().visibility());
    }

    @Test
    void anEndlessOneIsStoppedOnceForAllThatIsShown() {
        show(
                "visible-faces",
                ALL_VISIBLE.replace(
                        "java.util.Arrays.fill(all, true);", "while (all[0] == false);"),
                "cube");
        assertEquals(
                "Your program did not answer within 2 s and was stopped",
                VisibilityReadings.refusal(
                        OwnMethods.NAME,
                        picture().refusal().orElseThrow(),
                        Texts.of("visibility", Language.ENGLISH)));
        model.watchSteps(true);
        settle();
        assertEquals(Optional.empty(), model.state().drawn());
    }

    @Test
    void withoutAProgramItSaysHowToGetOne() {
        model.choose(choice -> choice.withVisibility(OwnMethods.NAME));
        settle();
        String said = picture().refusal().orElseThrow();
        assertTrue(said.startsWith("there is no program of yours yet"), said);
    }

    @Test
    void theCopiedCommandNamesAMethodThatTheTerminalKnows() {
        model.choose(choice -> choice.withVisibility(OwnMethods.NAME));
        assertTrue(command().contains("--visibility auto "), command());
        model.choose(choice -> choice.withComparison("bsp"));
        assertTrue(command().contains("--visibility bsp "), command());
        assertFalse(command().contains("\n"), command());
    }

    private String command() {
        return VisibilityCommand.now(model).text();
    }
}
