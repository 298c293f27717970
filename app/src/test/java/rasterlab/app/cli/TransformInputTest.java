package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Damaged input of the topics matrix, transform, view, rotate and rotate-axis. */
class TransformInputTest {
    private static final List<String[]> GOOD =
            List.of(
                    input(
                            "matrix",
                            "formula",
                            "{\"name\":\"VIEW_LEFT\",\"theta\":3,\"phi\":4,\"rho\":5}"),
                    input(
                            "matrix",
                            "formula-textbook",
                            "{\"name\":\"ROTAXIS\",\"through\":[1,2,3],\"direction\":[1,2,2],\"angle\":37}"),
                    input(
                            "transform",
                            "double",
                            "{\"matrices\":[{\"name\":\"ROT3DX\",\"angle\":9},[[1,0,0,0],[0,1,0,0],[0,0,1,0.5],[0,0,0,1]]],\"points\":[[1,2,3],[4,5,6]]}"),
                    input(
                            "transform",
                            "double-double",
                            "{\"matrices\":[[[1,2,0],[3,4,0],[5,6,1]]],\"points\":[[1,2]]}"),
                    input(
                            "view",
                            "one-matrix",
                            "{\"points\":[[1,2,3]],\"theta\":10,\"phi\":20,\"rho\":30}"),
                    input(
                            "rotate",
                            "quaternion",
                            "{\"points\":[[1,2],[3,4]],\"degrees\":33.5,\"times\":12}"),
                    input(
                            "rotate-axis",
                            "seven-steps",
                            "{\"points\":[[1,2,3]],\"through\":[1,1,1],\"direction\":[0,1,0],\"degrees\":45}"));
    private static final String[] PIECES = {
        "NaN",
        "1e999",
        "-1e308",
        "1e-320",
        "null",
        "[",
        "]",
        "{",
        "}",
        ",",
        ":",
        "\"",
        "-0.0",
        "0",
        "\"name\"",
        "[1,2,3]",
        "2147483648",
        "true",
        "\u0000",
        "é"
    };

    private static String[] input(String topic, String method, String json) {
        return new String[] {topic, method, json};
    }

    @Test
    void undamagedInputIsAnswered() {
        for (String[] good : GOOD) Ran.labReading(good[2], "run", good[0], good[1]).assertDone();
    }

    /** Answered, refused or complained about in one line: never a crash. */
    @Test
    void damagedInputNeverCrashes() {
        long seed = 1999;
        var random = new Random(seed);
        for (int i = 0; i < 400; i++) {
            String[] good = GOOD.get(i % GOOD.size());
            String damaged = damaged(good[2], random);
            Ran ran = Ran.labReading(damaged, "run", good[0], good[1]);
            String where = "seed " + seed + ", " + good[0] + " " + damaged + ": " + ran.err();
            assertTrue(ran.exitCode() == 0 || ran.exitCode() == 2 || ran.exitCode() == 3, where);
            assertFalse(ran.out().contains("NaN") || ran.out().contains("Infinity"), where);
            if (ran.exitCode() == 0) continue;
            assertEquals("", ran.out(), where);
            assertEquals(1, ran.err().lines().count(), where);
        }
    }

    private static String damaged(String json, Random random) {
        var text = new StringBuilder(json);
        for (int n = 1 + random.nextInt(2); n > 0; n--) {
            int at = random.nextInt(text.length());
            int length = random.nextInt(4);
            String piece = random.nextInt(3) == 0 ? "" : PIECES[random.nextInt(PIECES.length)];
            text.replace(at, Math.min(text.length(), at + length), piece);
        }
        return text.toString();
    }
}
