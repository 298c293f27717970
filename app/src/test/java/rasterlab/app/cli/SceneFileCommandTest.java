package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SceneFileCommandTest {
    private static final String VIEW =
            """
            {"version": 1, "scene": "cube", "camera": {"theta": 1, "phi": 1, "rho": 300},
             "projection": "cabinet",
             "look": {"visibility": "painter", "shading": "gouraud", "texture": "none"}}
            """;
    private static final String CASE =
            """
            {"version": 1, "topic": "line", "method": "dda", "input": {"from": [0, 0], "to": [5, 2]}}
            """;

    @TempDir Path folder;

    @Test
    void rendersAsTheFileSays() throws Exception {
        JsonNode said = rendered();
        assertEquals("cube", said.path("scene").asText());
        assertEquals("cabinet", said.path("projection").asText());
        assertEquals("painter", said.path("visibility").asText());
        assertEquals("gouraud", said.path("shading").asText());
        assertEquals("none", said.path("texture").asText());
        assertEquals(300, said.path("camera").path("rho").asDouble());
        String named = folder.resolve("named.png").toString();
        Ran.lab(
                        "render",
                        "cube",
                        "--camera",
                        "1,1,300",
                        "--projection",
                        "cabinet",
                        "--visibility",
                        "painter",
                        "--shading",
                        "gouraud",
                        "--texture",
                        "none",
                        "--size",
                        "80x60",
                        "--out",
                        named)
                .assertDone();
        assertArrayEquals(
                Files.readAllBytes(folder.resolve("named.png")),
                Files.readAllBytes(folder.resolve("out.png")));
    }

    @Test
    void commandLineCountsBeforeTheFile() throws Exception {
        JsonNode said =
                rendered(
                        "--projection",
                        "front",
                        "--visibility",
                        "zfloat",
                        "--shading",
                        "flat",
                        "--texture",
                        "linear",
                        "--camera",
                        "0,1,200");
        assertEquals("front", said.path("projection").asText());
        assertEquals("zfloat", said.path("visibility").asText());
        assertEquals("flat", said.path("shading").asText());
        assertEquals("linear", said.path("texture").asText());
        assertEquals(200, said.path("camera").path("rho").asDouble());
    }

    private JsonNode rendered(String... options) throws Exception {
        String[] all = new String[6 + options.length];
        String file = written(VIEW);
        String[] fixed = {
            "render", file, "--size", "80x60", "--out", "" + folder.resolve("out.png")
        };
        System.arraycopy(fixed, 0, all, 0, 6);
        System.arraycopy(options, 0, all, 6, options.length);
        Ran ran = Ran.lab(all);
        ran.assertDone();
        return new ObjectMapper().readTree(ran.out());
    }

    @Test
    void runsTheCaseOfAFile() throws Exception {
        String input = "{\"from\":[0,0],\"to\":[5,2]}";
        String file = written(CASE);
        assertEquals(
                Ran.labReading(input, "run", "line", "dda", "--steps").out(),
                Ran.lab("run", "--scene", file, "--steps").out());
        assertEquals(
                Ran.labReading(input, "run", "line", "wu").out(),
                Ran.lab("run", "wu", "--scene", file).out());
    }

    @Test
    void complainsWithThePath() throws Exception {
        String file = written(VIEW.replace("\"rho\": 300", "\"rho\": -3"));
        Ran.lab("render", file, "--out", "x.png")
                .assertComplains(
                        2,
                        "./lab render: "
                                + file
                                + ": $.camera.rho: must be a number from 0.001 to 1000000.0, got"
                                + " -3");
        Ran.lab("run", "--scene", written(VIEW))
                .assertComplains(
                        2,
                        "./lab run: %s: holds a view of a scene; `./lab render %s` takes it"
                                .formatted(file, file));
        Ran.lab("render", written(CASE), "--out", "x.png")
                .assertComplains(
                        2,
                        "./lab render: %s: holds an input of a topic; `./lab run --scene %s` takes it"
                                .formatted(file, file));
        Ran.lab("run", "--scene", written(CASE.replace("\"method\": \"dda\", ", "")))
                .assertComplains(2, "./lab run: " + file + ": names no method; give one: METHOD");
    }

    @Test
    void needsATopicOrAFile() {
        Ran.lab("run", "line")
                .assertComplains(
                        2,
                        "./lab run: needs TOPIC and METHOD, or --scene FILE; see `./lab methods`");
    }

    private String written(String text) throws Exception {
        Path file = folder.resolve("one.scene.json");
        Files.writeString(file, text);
        return file.toString();
    }
}
