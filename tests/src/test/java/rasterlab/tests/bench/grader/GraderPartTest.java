package rasterlab.tests.bench.grader;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.EnumSet;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class GraderPartTest {
    @ParameterizedTest(name = "--only {0} chooses other parts")
    @CsvSource(
            delimiter = '|',
            value = {"kills|kills", "kills,disk|disk kills", "disk, disk|disk", "class|class"})
    void choosesWhatIsNamedInTheOrderOfTheBench(String list, String chosen) {
        String words =
                GraderPart.in(list).stream().map(GraderPart::word).collect(Collectors.joining(" "));
        assertEquals(chosen, words);
        assertEquals(Optional.empty(), GraderPart.unknownIn(list));
    }

    @Test
    @DisplayName("without --only some part is left out")
    void choosesAllWithoutAList() {
        assertEquals(EnumSet.allOf(GraderPart.class), GraderPart.all());
    }

    @ParameterizedTest(name = "in --only {0} another name is called unknown, or none")
    @CsvSource(
            delimiter = '|',
            value = {
                "nosuch|nosuch",
                "disk,nosuch,worse|nosuch",
                "DISK|DISK",
                "disk,|''",
                "''|''",
                "' '|''"
            })
    void findsTheFirstNameThatNoPartHas(String list, String unknown) {
        assertEquals(Optional.of(unknown), GraderPart.unknownIn(list));
    }

    @Test
    @DisplayName("a part is a load and a fault, or none of all that are run")
    void eachPartIsRunOnce() {
        var all = EnumSet.of(GraderPart.SINGLE, GraderPart.KILLS);
        all.addAll(GraderPart.LOADS);
        all.addAll(GraderPart.FAULTS);
        assertEquals(EnumSet.allOf(GraderPart.class), all);
        assertEquals(all.size(), 2 + GraderPart.LOADS.size() + GraderPart.FAULTS.size());
    }
}
