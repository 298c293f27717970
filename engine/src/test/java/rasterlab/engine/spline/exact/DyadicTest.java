package rasterlab.engine.spline.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Tag("slow")
class DyadicTest {
    private static final MathContext DIGITS = new MathContext(2000);
    private static final BigDecimal TWO = BigDecimal.valueOf(2);

    @Property(tries = 2000, edgeCases = EdgeCasesMode.MIXIN)
    void computesAsDecimalsDo(
            @ForAll @DoubleRange(min = -1e20, max = 1e20) double a,
            @ForAll @DoubleRange(min = -1, max = 1) double b,
            @ForAll @DoubleRange(min = -1e20, max = 1e20) double c,
            @ForAll @IntRange(min = 1, max = 9) int factor) {
        BigDecimal product = new BigDecimal(a).multiply(new BigDecimal(b));
        BinaryFraction ours = BinaryFraction.of(a).times(BinaryFraction.of(b));
        assertSame(product.add(new BigDecimal(c)), ours.plus(BinaryFraction.of(c)));
        assertSame(product.subtract(new BigDecimal(c)), ours.minus(BinaryFraction.of(c)));
        assertSame(
                product.multiply(BigDecimal.valueOf(factor)),
                ours.times(BigInteger.valueOf(factor)));
        assertEquals(
                product.divide(BigDecimal.valueOf(factor), DIGITS).doubleValue(),
                ours.dividedBy(factor));
    }

    @ParameterizedTest
    @ValueSource(
            doubles = {
                0,
                1,
                -3,
                0.1,
                -0.1,
                6,
                1e100,
                -1e100,
                1e300,
                0x1p-1022,
                0x1.8p-1070,
                Double.MIN_VALUE
            })
    void standsForTheDouble(double value) {
        assertSame(new BigDecimal(value), BinaryFraction.of(value));
        assertEquals(value, BinaryFraction.of(value).toDouble());
        assertEquals(value, BinaryFraction.of(value).times(BigInteger.valueOf(3)).dividedBy(3));
    }

    @ParameterizedTest(name = "what is far beyond half a last place is lost: {0}")
    @ValueSource(ints = {1, -1})
    void leastBitDecidesWhatWouldBeATie(int sign) {
        BigInteger tie = BigInteger.ONE.shiftLeft(200).setBit(147);
        assertEquals(sign, new BinaryFraction(signed(sign, tie), 200).toDouble());
        assertEquals(
                sign * Math.nextUp(1.0),
                new BinaryFraction(signed(sign, tie.setBit(0)), 200).toDouble());
    }

    @ParameterizedTest(name = "what a division leaves is lost: {0}")
    @ValueSource(ints = {1, -1})
    void remainderDecidesWhatWouldBeATie(int sign) {
        BigInteger tie = BigInteger.ONE.shiftLeft(125).setBit(72);
        BigInteger thrice = tie.multiply(BigInteger.valueOf(3));
        assertEquals(sign, new BinaryFraction(signed(sign, thrice), 125).dividedBy(3));
        assertEquals(
                sign * Math.nextUp(1.0),
                new BinaryFraction(signed(sign, thrice.add(BigInteger.ONE)), 125).dividedBy(3));
    }

    private static BigInteger signed(int sign, BigInteger size) {
        return size.multiply(BigInteger.valueOf(sign));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.999999, 1, 2.5, 7, 8, 1e9, -0.5, -1, -2.5})
    void floorIsTheWholeNumberBelow(double value) {
        assertEquals((int) Math.floor(value), BinaryFraction.of(value).floor());
    }

    @Property(tries = 100, edgeCases = EdgeCasesMode.MIXIN)
    void floorIsBelowAWholeNumberThatIsMissedByLittle(@ForAll @IntRange(min = 1) int whole) {
        BinaryFraction missed = BinaryFraction.of(whole).minus(BinaryFraction.of(0x1p-100));
        assertEquals(whole, missed.toDouble());
        assertEquals(whole - 1, missed.floor());
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void whatIsNotFiniteIsRefused(double value) {
        var refusal = assertThrows(IllegalArgumentException.class, () -> BinaryFraction.of(value));
        assertEquals("must be finite, got " + value, refusal.getMessage());
    }

    private static void assertSame(BigDecimal expected, BinaryFraction actual) {
        BigDecimal over = new BigDecimal(actual.over());
        BigDecimal value =
                actual.places() < 0
                        ? over.multiply(TWO.pow(-actual.places()))
                        : over.divide(TWO.pow(actual.places()));
        assertEquals(0, expected.compareTo(value), expected + " and " + actual);
    }
}
