package rasterlab.app.hazard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.language.Language;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

class HazardPageTest {
    private static final Pattern CELL =
            Pattern.compile(
                    "<section id=\"([^\"]*)\"><h3 class=\"([a-z]*)\">.*?</section>",
                    Pattern.DOTALL);

    @ParameterizedTest(
            name = "{0}: an exact cell, or one of several inputs, has no picture or command")
    @ValueSource(strings = {"color", "rotate", "clip-polygon"})
    void everyCellHasItsPictureAndCommand(String name) {
        Topic<?, ?, ?> topic = Topics.named(name);
        String page = HazardPage.of(topic, HazardTrial.WALL_LIMIT, Language.ENGLISH).html();
        List<String[]> cells =
                CELL.matcher(page)
                        .results()
                        .map(cell -> new String[] {cell.group(1), cell.group(2), cell.group()})
                        .toList();
        assertEquals(
                ids(topic).toList(), cells.stream().map(cell -> cell[0]).toList(), "a cell each");
        for (String[] cell : cells) {
            String command = cell[2].replaceAll("</?span>", "");
            assertTrue(command.contains("<pre>./lab run " + name + " "), cell[0]);
            boolean answered = List.of("exact", "degraded", "wrong").contains(cell[1]);
            boolean shown = cell[2].contains("<svg role=\"img\"") || cell[2].contains("<img alt=");
            assertEquals(answered, shown, cell[0] + " is " + cell[1]);
            assertTrue(page.contains("href=\"#" + cell[0] + "\""), "the table leads there");
        }
        for (String used : page.split("<use href=\"#")) {
            String id = used.substring(0, Math.max(0, used.indexOf('"')));
            if (id.startsWith("right."))
                assertEquals(2, page.split("id=\"" + id + "\"").length, id);
        }
    }

    @Test
    @DisplayName("a line breaks behind a hyphen of a name, or inside an option")
    void commandsBreakBetweenWordsOnly() {
        assertEquals(
                "<pre>./lab run <span>clip-polygon</span> mine <span>--hazard</span> NaN</pre>\n",
                CommandHtml.of("./lab run clip-polygon mine --hazard NaN"));
        String page =
                HazardPage.of(Topics.named("rotate"), HazardTrial.WALL_LIMIT, Language.ENGLISH)
                        .html();
        assertTrue(page.contains(CommandHtml.STYLE), "nothing keeps them whole");
    }

    @Test
    @DisplayName("a row of numbers is made so small that nobody can read it")
    void pictureOfARowScrolls() {
        String page =
                HazardPage.of(
                                Topics.named("texture-filter"),
                                HazardTrial.WALL_LIMIT,
                                Language.ENGLISH)
                        .html();
        assertTrue(page.contains("<div class=\"scroll flat\"><svg"), "a right answer");
        assertTrue(page.contains("<div class=\"scroll flat\"><img"), "a difference");
    }

    private static Stream<String> ids(Topic<?, ?, ?> topic) {
        return topic.hazards().stream()
                .map(Hazard::name)
                .flatMap(
                        hazard ->
                                topic.methods().stream()
                                        .map(Method::name)
                                        .map(method -> VerdictTable.id(hazard, method)));
    }
}
