package rasterlab.app.tour;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class HtmlTest {
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
