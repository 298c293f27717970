package rasterlab.engine.transform.matrix;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.stream.Stream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.DoubleRange;
import org.joml.Matrix4d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.study.Deviation;

@Tag("slow")
class MatrixPropertyTest {
    private static final MatrixTopic TOPIC = new MatrixTopic();

    /** Matrices of every name, with parameters that they allow. */
    @Provide
    Arbitrary<MatrixCall> calls() {
        return Arbitraries.of(NamedMatrices.all()).flatMap(MatrixPropertyTest::callsOf);
    }

    private static Arbitrary<MatrixCall> callsOf(NamedMatrix matrix) {
        return Arbitraries.doubles()
                .between(-1000, 1000)
                .array(double[].class)
                .ofSize(matrix.numbers())
                .map(numbers -> MatrixCall.of(matrix.name(), fitted(matrix, numbers)));
    }

    /** The numbers brought into the parameters' ranges. */
    private static double[] fitted(NamedMatrix matrix, double[] numbers) {
        int next = 0;
        for (MatrixParameter parameter : matrix.parameters())
            for (int i = 0; i < parameter.size(); i++, next++) {
                double share = (Math.abs(numbers[next]) + 0.5) / 1001;
                switch (parameter.range()) {
                    case INSIDE_UNIT, UNIT -> numbers[next] = share;
                    case HALF_TURN -> numbers[next] = 180 * share;
                    case POSITIVE -> numbers[next] = 1000 * share;
                    case NOT_ZERO -> numbers[next] = numbers[next] == 0 ? 1 : numbers[next];
                    default -> {}
                }
            }
        return numbers;
    }

    @Property(tries = 3000)
    void formulaIsExactOrRefusesSayingWhy(@ForAll("calls") MatrixCall call) {
        double[][] rows;
        try {
            rows = TOPIC.record(new NamedFormula(), call, 1);
        } catch (IllegalArgumentException refusal) {
            assertTrue(refusal.getMessage().matches(".*(must|too large).*"), refusal.getMessage());
            return;
        }
        Deviation deviation = TOPIC.compare(call, TOPIC.exact(call, 1), rows);
        assertTrue(TOPIC.correct(deviation), () -> call + " " + deviation);
    }

    /** Each cell of the product, over the magnitudes that make it: its terms and the numbers. */
    @Property(tries = 3000)
    void matrixTimesTheInverseItNamesIsOne(@ForAll("calls") MatrixCall call) {
        NamedMatrix matrix = NamedMatrices.named(call.name());
        double[][] rows;
        try {
            rows = matrix.rows(call.parameters());
        } catch (IllegalArgumentException refused) {
            return;
        }
        matrix.inverseRows(call.parameters())
                .ifPresent(inverse -> assertProductIsOne(call, rows, inverse));
    }

    @ParameterizedTest(name = "{0} names a wrong inverse or none")
    @MethodSource("modest")
    void everyMatrixThatDoesNotFlattenHasAnInverse(MatrixCall call) {
        NamedMatrix matrix = NamedMatrices.named(call.name());
        Optional<double[][]> inverse = matrix.inverseRows(call.parameters());
        assertEquals(matrix.inverse() != MatrixInverse.NONE, inverse.isPresent());
        inverse.ifPresent(rows -> assertProductIsOne(call, matrix.rows(call.parameters()), rows));
    }

    static Stream<MatrixCall> modest() {
        return new MatrixTopic().workloads().stream().flatMap(w -> w.inputs().stream());
    }

    private static void assertProductIsOne(MatrixCall call, double[][] m, double[][] inverse) {
        int size = m.length;
        double largest = 1;
        for (double number : call.numbers()) largest = Math.max(largest, Math.abs(number));
        for (int i = 0; i < size; i++)
            for (int j = 0; j < size; j++) {
                double sum = 0;
                double magnitudes = largest;
                for (int k = 0; k < size; k++) {
                    sum += m[i][k] * inverse[k][j];
                    magnitudes += Math.abs(m[i][k] * inverse[k][j]);
                }
                String place = call + ", row " + (i + 1) + ", column " + (j + 1);
                assertEquals(i == j ? 1 : 0, sum, 1e-14 * magnitudes, place);
            }
    }

    @Property(tries = 500)
    void inverseOfARotationIsItsTransposeAndItsNegativeAngle(
            @ForAll("turns") String name,
            @ForAll @DoubleRange(min = -720, max = 720) double angle) {
        Matrix4d turn = WorkedMatricesTest.joml(name, angle);
        Matrix4d transposed = new Matrix4d(turn).transpose();
        assertTrue(transposed.equals(new Matrix4d(turn).invert(), 1e-15), name);
        assertTrue(transposed.equals(WorkedMatricesTest.joml(name, -angle), 0), name);
    }

    @Property(tries = 500)
    void rotationsAboutOneAxisAddTheirAngles(
            @ForAll("turns") String name,
            @ForAll @DoubleRange(min = -360, max = 360) double first,
            @ForAll @DoubleRange(min = -360, max = 360) double second) {
        Matrix4d both =
                WorkedMatricesTest.joml(name, second).mul(WorkedMatricesTest.joml(name, first));
        assertTrue(both.equals(WorkedMatricesTest.joml(name, first + second), 4e-15), name);
    }

    @Property(tries = 300)
    void shiftsAddAndScalesMultiply(
            @ForAll @DoubleRange(min = -9, max = 9) double a,
            @ForAll @DoubleRange(min = 1, max = 9) double b) {
        Matrix4d shifts =
                WorkedMatricesTest.joml("TRANSL3D", b, a, b)
                        .mul(WorkedMatricesTest.joml("TRANSL3D", a, b, a));
        assertTrue(shifts.equals(WorkedMatricesTest.joml("TRANSL3D", a + b, a + b, a + b), 1e-14));
        Matrix4d scales =
                WorkedMatricesTest.joml("SCALE3DX", a).mul(WorkedMatricesTest.joml("SCALE3DX", b));
        assertEquals(a * b, scales.m00(), 0);
    }

    @Property(tries = 300)
    void turningAboutAnyPointIsShiftTurnShiftBack(
            @ForAll @DoubleRange(min = -99, max = 99) double x,
            @ForAll @DoubleRange(min = -99, max = 99) double y,
            @ForAll @DoubleRange(min = -360, max = 360) double angle) {
        Matrix4d steps =
                WorkedMatricesTest.joml("TRANSL3D", x, y, 0)
                        .mul(WorkedMatricesTest.joml("ROT3DZ", angle))
                        .mul(WorkedMatricesTest.joml("TRANSL3D", -x, -y, 0));
        Matrix4d axis = WorkedMatricesTest.joml("ROTAXIS", x, y, 0, 0, 0, 1, angle);
        assertTrue(steps.equals(axis, 1e-12), () -> steps + "\n" + axis);
    }

    @Provide
    Arbitrary<String> turns() {
        return Arbitraries.of("ROT3DX", "ROT3DY", "ROT3DZ");
    }
}
