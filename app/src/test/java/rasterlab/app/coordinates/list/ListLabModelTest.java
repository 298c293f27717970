package rasterlab.app.coordinates.list;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.transform.matrix.MatrixCall;

class ListLabModelTest {
    private final ListLabModel model =
            new ListLabModel(
                    Runnable::run,
                    failure -> {
                        throw new AssertionError(failure);
                    });

    @AfterEach
    void close() {
        model.close();
    }

    private double[] images(int step) {
        return model.scene().images(step, false);
    }

    @ParameterizedTest(name = "the two readings end at different pictures: {0}")
    @EnumSource(Example.class)
    void bothReadingsEndAtOnePicture(Example example) {
        model.show(example);
        model.read(Reading.OBJECTS);
        double[] backwards = images(model.last());
        model.read(Reading.FRAME);
        assertArrayEquals(backwards, images(model.last()), 1e-12);
    }

    @Test
    @DisplayName("the readings are exchanged")
    void readsBackwardsWhenObjectsMove() {
        model.show(Example.TWO_READINGS);
        model.read(Reading.OBJECTS);
        double[] first = images(1);
        assertArrayEquals(new double[] {2, 0}, Arrays.copyOfRange(first, 2, 4), 1e-12);
        assertEquals(2, model.scene().newest(1));
        model.read(Reading.FRAME);
        double[] moved = images(1);
        assertArrayEquals(new double[] {5, 1}, Arrays.copyOfRange(moved, 2, 4), 1e-12);
        assertEquals(0, model.scene().newest(1));
    }

    @Test
    @DisplayName("the course's triangle turns the wrong way round")
    void turnsTheCoursesTriangle() {
        model.show(Example.QUARTER_TURN);
        assertArrayEquals(new double[] {1, 3, -1, 4, -1, 2}, images(1), 1e-12);
    }

    @Test
    @DisplayName("factors are exchanged")
    void multipliesTheCoursesMatrices() {
        model.show(Example.PRODUCT);
        double[] corners = images(model.last());
        assertArrayEquals(
                new double[] {0, 0, 3, 1, 14, 8, 11, 7}, Arrays.copyOf(corners, 8), 1e-12);
    }

    @Test
    @DisplayName("a row and a column of a typed matrix are exchanged")
    void multipliesRowsByATypedMatrix() {
        model.show(Example.PROJECTIVE);
        double[] corner = Arrays.copyOfRange(images(1), 2, 4);
        assertArrayEquals(new double[] {2 / 1.4, 0}, corner, 1e-12);
        model.set(6, 7);
        assertEquals(9 / 1.4, images(1)[2], 1e-12);
    }

    @Test
    @DisplayName("a misprinted matrix passes for the right one")
    void showsPrintedMatricesBesideTheRightOnes() {
        for (Hazard<MatrixCall> hazard : model.hazards()) {
            model.show(hazard);
            Verdict.Kind printed = hazard.recorded().get("formula-textbook");
            boolean wrong = printed == Verdict.Kind.WRONG;
            boolean axisOfNoNumber = hazard.name().equals("axis-along-z");
            if (!axisOfNoNumber) assertEquals(wrong, model.scene().wrong(), hazard.name());
            // Its cells are right, but the points' products with them are no doubles.
            boolean tooLargeToDraw = hazard.name().equals("box-of-largest-doubles");
            assertEquals(
                    printed == Verdict.Kind.REFUSED || axisOfNoNumber || tooLargeToDraw,
                    model.scene().isRefused(),
                    hazard.name());
            if (printed == Verdict.Kind.EXACT && !model.scene().isRefused())
                assertTrue(model.correct(model.deviation().orElseThrow()), hazard.name());
        }
    }

    @Test
    @DisplayName("a number out of its range breaks the lab")
    void refusedMatrixIsNamedWithItsRange() {
        model.show(Example.SPACE);
        model.add("SCALE3D");
        model.set(0, 0);
        assertTrue(model.scene().isRefused());
        assertEquals(1, model.scene().refused());
        assertEquals(0, model.last());
        String english =
                ListReadings.refusal(model.scene(), Texts.of("coordinates.list", Language.ENGLISH));
        assertTrue(english.contains("s must be a finite number other than 0, got 0.0"), english);
        String russian =
                ListReadings.refusal(model.scene(), Texts.of("coordinates.list", Language.RUSSIAN));
        assertTrue(russian.contains("не равное 0"), russian);
        model.set(0, 0.5);
        assertFalse(model.scene().isRefused());
    }

    @Test
    @DisplayName("a matrix is added elsewhere than behind the selected one")
    void editsTheListAtTheSelectedPlace() {
        model.show(Example.TWO_READINGS);
        model.select(0);
        model.add("SHEAR2D");
        assertEquals(List.of("TRANSL2D", "SHEAR2D", "ROT2D", "SCALE2D"), names());
        assertEquals(1, model.choice().selected());
        assertEquals(4, model.step(), "the new matrix is not seen");
        model.move(1);
        assertEquals(List.of("TRANSL2D", "ROT2D", "SHEAR2D", "SCALE2D"), names());
        model.remove();
        assertEquals(List.of("TRANSL2D", "ROT2D", "SCALE2D"), names());
        model.history().undo();
        model.history().undo();
        model.history().undo();
        assertEquals(List.of("TRANSL2D", "ROT2D", "SCALE2D"), names());
    }

    private List<String> names() {
        return model.choice().items().stream().map(ListItem::name).toList();
    }

    @Test
    @DisplayName("a list grows without end, or an empty one cannot be emptied")
    void listsHaveTwoEnds() {
        for (int i = 0; i < 20; i++) model.add("ROT2D");
        assertEquals(ListChoice.MOST, model.choice().items().size());
        for (int i = 0; i < 20; i++) model.remove();
        assertEquals(List.of(), model.choice().items());
        assertEquals(-1, model.choice().selected());
        model.move(1);
        model.add("ROT2D");
        assertEquals(0, model.choice().selected());
    }

    @Test
    @DisplayName("matrices of the plane stay in a list of space")
    void subjectOfTheOtherDimensionBringsAListOfItsOwn() {
        model.choose(Subject.HOUSE);
        assertTrue(model.choice().items().stream().allMatch(item -> item.dimension() == 3));
        model.choose(Subject.TRIANGLE);
        assertTrue(model.choice().items().stream().allMatch(item -> item.dimension() == 2));
    }

    @Test
    @DisplayName("a matrix of the chooser cannot be added")
    void everyNameIsAddedWithNumbersThatAreAllowed() {
        for (Subject subject : List.of(Subject.SQUARE, Subject.CUBE))
            for (String name : model.names(subject.wire().dimension())) {
                model.choose(subject);
                while (model.choice().selected() >= 0) model.remove();
                model.add(name);
                assertFalse(model.scene().isRefused(), name + ": " + model.scene().refusal());
                assertEquals(1, model.last(), name);
            }
    }

    @Test
    @DisplayName("a dragged corner leaves its image where it was")
    void imagesFollowTheirPoints() {
        model.show(Example.OTHER_ORDER);
        double before = images(model.last())[0];
        model.movePoint(0, -1, -1);
        assertTrue(Math.abs(images(model.last())[0] - before) > 0.1);
        assertEquals(List.of(-1.0, -1.0), model.choice().points().subList(0, 2));
    }
}
