package rasterlab.engine.study.measuring;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class QuantileTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void liesLinearlyBetweenTheTwoValuesNextToIt(double expected, double share, double[] sorted) {
        assertEquals(expected, MedianInterval.quantile(sorted, share));
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("the odd median is not the middle value", 2.0, 0.5, of(1, 2, 30)),
                argumentSet("the even median takes one of two", 16.0, 0.5, of(1, 2, 30, 40)),
                argumentSet("the lower quartile is the median", 2.0, 0.25, of(1, 2, 30, 40, 50)),
                argumentSet("the upper quartile is the largest", 40.0, 0.75, of(1, 2, 30, 40, 50)),
                argumentSet("the lower quartile is rounded down", 1.75, 0.25, of(1, 2, 30, 40)),
                argumentSet("the upper quartile is rounded up", 32.5, 0.75, of(1, 2, 30, 40)),
                argumentSet("the largest is read past the end", 30.0, 1.0, of(1, 2, 30)),
                argumentSet("a single value has no median", 7.0, 0.5, of(7)));
    }

    private static double[] of(double... sorted) {
        return sorted;
    }
}
