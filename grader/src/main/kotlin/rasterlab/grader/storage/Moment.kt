package rasterlab.grader.storage

import java.time.Instant
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter

private val format = DateTimeFormatter.ofPattern("uuuu-MM-dd'T'HH:mm:ss.SSS'Z'").withZone(ZoneOffset.UTC)

/** UTC with always three decimals of a second, so that text order is time order. */
fun Instant.text(): String = format.format(this)
