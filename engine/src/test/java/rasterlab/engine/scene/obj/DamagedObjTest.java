package rasterlab.engine.scene.obj;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** Damaged files give a model or a message; 200,000 with {@code -Drasterlab.full=true}. */
class DamagedObjTest {
    private static final int FILES = Boolean.getBoolean("rasterlab.full") ? 200_000 : 4_000;

    private static final String WHOLE =
            """
            mtllib m.mtl
            v 0 0 0
            v 4 0 0 1
            v 4 4 0.5
            v 0 4 0 1 0 0.5
            v 2 2 3
            vt 0 0
            vt 1 0.5
            vn 0 0 1
            s 1
            usemtl red
            f 1/1/1 2/2/1 3/1/1 4/2/1
            f 1 2 5
            g side
            s off
            f -5 -4 -1 \\
              -3
            usemtl blue sky
            f 1//1 5//1 3//1 2//1 4//1
            f 3 4 5
            """;

    private static final String MATERIALS =
            "newmtl red\nKd 1 0 0\nNs 10\nmap_Kd a.png\nnewmtl blue sky\nd 0.5\nillum 2\n";

    private static final String[] PIECES = {
        "0",
        "-1",
        "9",
        "1e30",
        "1e-170",
        "1e-90",
        "nan",
        "/",
        "//",
        "\\\n",
        "\r",
        "\n",
        " ",
        "#",
        "f ",
        "v ",
        "vn ",
        "usemtl ",
        "mtllib m.mtl\n",
        "curv ",
        "\uFEFF",
        "\u0000",
        "é",
        "f 1 2 3 4 5\n",
        "."
    };

    @Test
    @DisplayName("a damaged file makes a reader fall over")
    void givesAModelOrAMessage() {
        int models = 0;
        for (int seed = 0; seed < FILES; seed++) {
            var random = new Random(seed);
            boolean materials = random.nextInt(4) == 0;
            String obj = materials ? WHOLE : damaged(WHOLE, random);
            String mtl = materials ? damaged(MATERIALS, random) : MATERIALS;
            if (isModel(obj, mtl, seed)) models++;
        }
        assertTrue(models > FILES / 50, "only " + models + " models were left");
        assertTrue(models < FILES, "nothing was damaged");
    }

    private static boolean isModel(String obj, String mtl, int seed) {
        try {
            readAllNumbers(Texts.read(obj, mtl));
            return true;
        } catch (BrokenFileException broken) {
            boolean named = broken.getMessage().matches("(?s)(a.obj|m.mtl|my m.mtl)(:\\d+)?: .*");
            assertTrue(named, "seed " + seed + ": " + broken.getMessage());
            return false;
        } catch (Exception other) {
            return fail("seed " + seed + ":\n" + obj, other);
        }
    }

    /** Fails by an index where a number names nothing. */
    private static void readAllNumbers(ObjModel model) {
        double sum = 0;
        for (int f = 0; f < model.faceCount(); f++) {
            sum += model.materials().get(model.material(f)).opacity();
            for (int k = 0; k < model.cornerCount(f); k++) {
                sum += model.positions()[3 * model.position(f, k) + 2];
                sum += model.normals()[3 * model.normal(f, k) + 2];
                int place = model.texturePlace(f, k);
                if (place >= 0) sum += model.texturePlaces()[2 * place + 1];
            }
        }
        for (int s = 0; s < model.strokeCount(); s++) {
            sum += model.materials().get(model.strokeMaterial(s)).opacity();
            sum += model.positions()[3 * model.strokeFrom(s) + 2];
            sum += model.positions()[3 * model.strokeTo(s) + 2];
        }
        assertTrue(Double.isFinite(sum), "a number is not finite");
    }

    private static String damaged(String text, Random random) {
        var damaged = new StringBuilder(text);
        for (int i = random.nextInt(4); i >= 0; i--) {
            int at = random.nextInt(damaged.length());
            int end = Math.min(damaged.length(), at + random.nextInt(6));
            String piece = PIECES[random.nextInt(PIECES.length)];
            switch (random.nextInt(4)) {
                case 0 -> damaged.insert(at, piece);
                case 1 -> damaged.replace(at, end, piece);
                case 2 -> damaged.delete(at, end).append('\n');
                default -> damaged.insert(at, damaged.substring(at, end));
            }
        }
        return damaged.toString();
    }
}
