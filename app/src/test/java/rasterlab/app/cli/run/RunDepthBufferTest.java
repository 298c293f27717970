package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;

/** Topic depth-buffer by {@code ./lab run}. */
class RunDepthBufferTest {
    @Test
    void tellsWhatIsStoredAndWhatIsToldApart() {
        Ran ran =
                Ran.labReading(
                        "{\"near\":1,\"far\":65536,\"depths\":[65536,2,1]}",
                        "run",
                        "depth-buffer",
                        "linear-16");
        assertEquals(
                "{\"codes\":[65535,1,0],\"stored\":[65535.0,1.0,0.0],\"z\":[65536.0,2.0,1.0],"
                        + "\"separable\":[null,0.5,0.5],\"front\":[2]}\n",
                ran.out());
        ran.assertDone();
    }

    @Test
    void withoutFarThereIsNoFarPlane() {
        Ran.labReading("{\"near\":1,\"depths\":[4]}", "run", "depth-buffer", "linear-16")
                .assertComplains(
                        3,
                        "./lab run: linear-16 refuses: far must be finite for equal steps of depth, got Infinity");
        Ran ran =
                Ran.labReading("{\"near\":1,\"depths\":[4]}", "run", "depth-buffer", "reversed-z");
        assertEquals(
                "{\"codes\":[-1048576000],\"stored\":[0.25],\"z\":[4.0],"
                        + "\"separable\":[1.1920929399167335E-7],\"front\":[0]}\n",
                ran.out());
        ran.assertDone();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(String json, String message) {
        Ran.labReading(json, "run", "depth-buffer", "z24")
                .assertComplains(2, "./lab run: " + message);
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "planes in the wrong order",
                        "{\"near\":9,\"far\":8,\"depths\":[8.5]}",
                        "/far: must be at least 1.000001·near and at most 1e100, or infinite, got 8 with near 9"),
                argumentSet(
                        "near plane in the eye",
                        "{\"near\":0,\"far\":8,\"depths\":[5]}",
                        "/near: must be from 1e-100 to 1e100, got 0"),
                argumentSet(
                        "depth behind the far plane",
                        "{\"near\":1,\"far\":8,\"depths\":[5,9]}",
                        "/depths/1: must be finite and from near to far, 1 to 8, got 9"),
                argumentSet(
                        "row without its length",
                        "{\"near\":1,\"far\":8,\"depths\":[5],\"to\":[6]}",
                        "/pixels: missing, to needs it"),
                argumentSet(
                        "depths at one end of the row alone",
                        "{\"near\":1,\"far\":8,\"depths\":[5,6],\"to\":[6],\"pixels\":4}",
                        "/to: expected 2 depths as /depths has, got 1"),
                argumentSet(
                        "more than can be stored",
                        "{\"near\":1,\"far\":8,\"depths\":["
                                + "5,".repeat(16)
                                + "5],\"pixels\":8192}",
                        "/pixels: at most 131072 surfaces times pixels, got 139264"));
    }
}
