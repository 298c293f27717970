package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import rasterlab.exercises.score.CasePicture
import rasterlab.exercises.score.Message
import rasterlab.exercises.score.PictureBytes
import rasterlab.exercises.score.PicturePart
import java.security.MessageDigest
import java.util.HexFormat
import java.util.Optional
import java.util.function.Supplier
import kotlin.jvm.optionals.getOrNull

/** The pictures of one report's cases, each with its text as data. */
internal class PictureRows(
    private val handle: Handle,
    private val result: String,
) {
    /** @param case its place in the report */
    fun insert(
        case: Int,
        pictures: List<CasePicture>,
    ) {
        for ((position, picture) in pictures.withIndex()) {
            val png = picture.png()
            handle
                .createUpdate(
                    """INSERT INTO case_pictures (result_id, case_position, position, kind, png, png_hash,
                           png_ru, text, text_data, part)
                       VALUES (:result, :case, :position, :kind, :png, :hash, :russian, :text, :data, :part)""",
                ).bind("result", result)
                .bind("case", case)
                .bind("position", position)
                .bind("kind", picture.kind())
                .bind("png", png)
                .bind("hash", hash(png))
                .bind("russian", picture.russian())
                .bind("text", picture.text().`in`("en"))
                .bind("data", picture.text().data())
                .bind("part", picture.part().getOrNull()?.data())
                .execute()
        }
    }

    /** The pictures of each case, by its place in the report. */
    fun all(): Map<Int, List<CasePicture>> =
        handle
            .createQuery(
                """SELECT * FROM case_pictures WHERE result_id = :result
                   ORDER BY case_position, position""",
            ).bind("result", result)
            .map { row, _ ->
                row.getInt("case_position") to
                    CasePicture(
                        row.getString("kind"),
                        file(row.getBytes("png"), row.getBytes("png_ru")),
                        Message.ofData(row.getString("text_data"), row.getString("text")),
                        Optional.ofNullable(row.getString("part")).flatMap(PicturePart::ofData),
                    )
            }.list()
            .groupBy({ it.first }, { it.second })
}

/** A hash of what is shown, which tells whether two answers are one. */
internal fun hash(bytes: ByteArray): String =
    HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes))

/** The picture in Russian where it is another one than in English; null elsewhere. */
internal fun CasePicture.russian(): ByteArray? = if (file().hasOwn(RUSSIAN)) png(RUSSIAN) else null

private fun file(
    usual: ByteArray,
    russian: ByteArray?,
): PictureBytes = PictureBytes.of(usual, russian?.let { mapOf(RUSSIAN to Supplier { it }) }.orEmpty())

private const val RUSSIAN = "ru"
