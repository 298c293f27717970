package rasterlab.exercises.graded;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.Topics;

/** The table of an answer's numbers beside the right ones. */
class AnswerPicturesTest {
    private static JsonNode json(String text) throws IOException {
        return new ObjectMapper().readTree(text.replace('\'', '"'));
    }

    private static String difference(String exact, String actual) throws IOException {
        var fields =
                new FormFields(Topics.named("color").format(), json("{'rgb': [0.5, 0.25, 0]}"));
        return new FormPictures(fields, json(exact), json(actual)).drawn().get(2).text().in("en");
    }

    @Test
    @DisplayName("a wrong share is not marked beside a hue that is wrong by many degrees")
    void everyWrongCellIsMarked() throws IOException {
        String said =
                difference(
                        "{'cmy': [0.5, 0.75, 1], 'hsv': [30, 1, 0.5]}",
                        "{'cmy': [0.5, 0.25, 1], 'hsv': [150, 1, 0.9]}");
        assertTrue(said.startsWith("cells that differ: 3 of 6;"), said);
    }

    @Test
    @DisplayName("rounding is marked as a mistake beside one")
    void roundingIsNotMarked() throws IOException {
        String said =
                difference(
                        "{'cmy': [0.5, 0.75, 1], 'hsv': [30, 1, 0.5]}",
                        "{'cmy': [0.5000000000000001, 0.75, 1], 'hsv': [150, 1, 0.5]}");
        assertTrue(said.startsWith("cells that differ: 1 of 6;"), said);
    }

    @Test
    @DisplayName("where nothing differs but by rounding, no cell is marked")
    void theSmallestDifferenceIsMarkedWhereItIsTheOnlyOne() throws IOException {
        List<String> said = new ArrayList<>();
        for (String share : List.of("0.5", "0.5000000000000001"))
            said.add(difference("{'cmy': [0.5, 0.75, 1]}", "{'cmy': [" + share + ", 0.75, 1]}"));
        assertEquals("there is no difference", said.get(0));
        assertTrue(said.get(1).startsWith("cells that differ: 1 of 3;"), said.get(1));
    }
}
