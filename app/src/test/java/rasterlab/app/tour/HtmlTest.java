package rasterlab.app.tour;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HtmlTest {
    @ParameterizedTest(name = "a number stands to the left: {0}")
    @ValueSource(strings = {"1,5", "−3", "1,2·10⁻⁷", "0,0013\u00a0%", "2,07–2,64", "–", "23/100"})
    void numbersStandToTheRight(String number) {
        String table = Html.table(List.of("method", "n"), List.of(List.of("a", number)));
        assertTrue(table.contains("<td class=\"number\">" + number + "</td>"), table);
    }

    @Test
    @DisplayName("sentence stretches its column, or turns numbers to the left")
    void lastCellOfAShortRowReachesToTheEnd() {
        String table =
                Html.table(
                        List.of("method", "pixels", "ms"),
                        List.of(List.of("a", "3", "1.5"), List.of("b", "refuses < it")));
        assertEquals(
                """
                <div class="scroll"><table>
                <thead><tr><th>method</th><th class="number">pixels</th><th class="number">ms</th>\
                </tr></thead>
                <tbody>
                <tr><td>a</td><td class="number">3</td><td class="number">1.5</td></tr>
                <tr><td>b</td><td colspan="2">refuses &lt; it</td></tr>
                </tbody></table></div>
                """,
                table);
    }
}
