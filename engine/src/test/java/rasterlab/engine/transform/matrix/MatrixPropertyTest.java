package rasterlab.engine.transform.matrix;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.joml.Matrix4d;
import rasterlab.engine.study.Deviation;

class MatrixPropertyTest {
    private static final MatrixTopic TOPIC = new MatrixTopic();

    /** Any matrix with any parameters that it allows. */
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

    @Property(tries = 500)
    void matrixTimesItsInverseIsOne(@ForAll("calls") MatrixCall call) {
        if (NamedMatrices.named(call.name()).size() == 3) return;
        Matrix4d matrix;
        try {
            matrix = WorkedMatricesTest.joml(call.name(), call.parameters());
        } catch (IllegalArgumentException refused) {
            return;
        }
        if (Math.abs(matrix.determinant()) < 1e-3) return;
        Matrix4d product = new Matrix4d(matrix).invert().mul(matrix);
        assertTrue(product.equals(new Matrix4d(), 1e-3), () -> call + "\n" + product);
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
