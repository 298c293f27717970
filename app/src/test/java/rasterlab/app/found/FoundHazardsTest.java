package rasterlab.app.found;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.outcome.Complaint;
import rasterlab.exercises.scene.MethodCase;

class FoundHazardsTest {
    @TempDir private Path settings;

    private static MethodCase find(String topic, int x) {
        return new MethodCase(
                topic,
                Optional.of("dda"),
                "{\"from\":[0,0],\"to\":[%d,1]}".formatted(x),
                Optional.empty(),
                Optional.of(new MethodCase.SearchFinding("wrong", 5)));
    }

    private FoundHazards all() {
        return FoundHazards.in(settings);
    }

    private List<MethodCase> kept(String topic) {
        return all().of(topic).stream().map(FoundHazards.KeptFind::scene).toList();
    }

    @Test
    void eachTopicHasItsOwnFinds() {
        all().keep(find("line", 3));
        all().keep(find("line", 4));
        all().keep(find("line-window", 3));
        assertEquals(List.of(find("line", 3), find("line", 4)), kept("line"));
        assertEquals(List.of(find("line-window", 3)), kept("line-window"));
        assertEquals(List.of(), kept("circle"));
    }

    @Test
    void theSameFindIsKeptOnce() {
        Path first = all().keep(find("line", 3));
        assertEquals(first, all().keep(find("line", 3)));
        assertEquals(1, kept("line").size());
    }

    @Test
    void removedFindIsGoneAndItsNameFree() {
        all().keep(find("line", 3));
        all().keep(find("line", 4));
        all().remove(all().of("line").get(0));
        assertEquals(List.of(find("line", 4)), kept("line"));
        all().keep(find("line", 5));
        assertEquals(List.of(find("line", 5), find("line", 4)), kept("line"));
    }

    @Test
    void whatIsNoFindIsLeftWhereItIs() throws IOException {
        Path folder = all().keep(find("line", 3)).getParent();
        Path broken = Files.writeString(folder.resolve("line.dda.2.scene.json"), "{");
        Path other = Files.writeString(folder.resolve("line.txt"), "notes");
        assertEquals(List.of(find("line", 3)), kept("line"));
        assertEquals(
                folder.resolve("line.dda.3.scene.json"), all().keep(find("line", 4)), "broken one");
        assertTrue(Files.exists(broken) && Files.exists(other));
    }

    @Test
    void oneMethodHasSoManyAndNoMore() {
        for (int x = 0; x < FoundHazards.MOST; x++) all().keep(find("line", x));
        var full = assertThrows(Complaint.class, () -> all().keep(find("line", 99)));
        assertTrue(full.getMessage().endsWith("has 20 hazards of dda already; remove one"));
    }
}
